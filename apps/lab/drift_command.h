#pragma once

#include "apps/lab/command.h"

namespace carina::lab
{

/// `carina-lab drift`: how far the views of a shared object are apart, in virtual time.
[[nodiscard]] Command driftCommand();

} // namespace carina::lab
