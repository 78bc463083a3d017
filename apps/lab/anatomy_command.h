#pragma once

#include "apps/lab/command.h"

namespace carina::lab
{

/// `anatomy import DIR` and `anatomy list DIR`: what an anatomy set is read as; `anatomy compare`:
/// how near a built-in patient is to one.
[[nodiscard]] Command anatomyCommand();

} // namespace carina::lab
