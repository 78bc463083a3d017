#pragma once

#include "apps/lab/command.h"

namespace carina::lab
{

/// `render`: how well what a headset shows lies over what is there, and pictures of patients.
[[nodiscard]] Command renderCommand();

} // namespace carina::lab
