#pragma once

#include "apps/lab/command.h"

namespace carina::lab
{

/// `summary DIR`: what a headless demo measured, from the logs of its processes.
[[nodiscard]] Command summaryCommand();

} // namespace carina::lab
