#pragma once

#include "apps/lab/command.h"

namespace carina::lab
{

/// `deform`: how well the field that moves the lungs follows the lungs of people.
[[nodiscard]] Command deformCommand();

} // namespace carina::lab
