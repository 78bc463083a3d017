#pragma once

#include "apps/lab/command.h"

namespace carina::lab
{

/// `track`: what a recording of a tracker holds, per tool.
[[nodiscard]] Command trackCommand();

} // namespace carina::lab
