#pragma once

#include "apps/lab/command.h"

namespace carina::lab
{

/// `anatomy import DIR` and `anatomy list DIR`: what an anatomy set is read as.
[[nodiscard]] Command anatomyCommand();

} // namespace carina::lab
