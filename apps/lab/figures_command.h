#pragma once

#include "apps/lab/command.h"

namespace carina::lab
{

/// `carina-lab figures`: the drift experiment as figures and tables.
[[nodiscard]] Command figuresCommand();

} // namespace carina::lab
