#pragma once

#include "apps/lab/command.h"

namespace carina::lab
{

/// `icp`: a registration refined by points swabbed on a surface.
[[nodiscard]] Command icpCommand();

} // namespace carina::lab
