#pragma once

#include "apps/lab/command.h"

namespace carina::lab
{

/// `pivot`: where a stylus has its tip, from poses with its tip in a divot.
[[nodiscard]] Command pivotCommand();

} // namespace carina::lab
