#pragma once

#include "apps/lab/command.h"

namespace carina::lab
{

/// How large the error of a registration will be at targets, before anything is touched.
[[nodiscard]] Command treCommand();

} // namespace carina::lab
