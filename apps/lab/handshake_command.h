#pragma once

#include "apps/lab/command.h"

namespace carina::lab
{

/// `handshake`: how long it takes to come into a session over a bad path.
[[nodiscard]] Command handshakeCommand();

} // namespace carina::lab
