#pragma once

#include "apps/lab/command.h"

namespace carina::lab
{

/// `breathe`: how well the volume of the lungs drawn follows the volume commanded.
[[nodiscard]] Command breatheCommand();

} // namespace carina::lab
