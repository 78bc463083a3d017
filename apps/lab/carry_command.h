#pragma once

#include "apps/lab/command.h"

namespace carina::lab
{

/// `carry`: what it costs a session that an anatomy set is sent beside it.
[[nodiscard]] Command carryCommand();

} // namespace carina::lab
