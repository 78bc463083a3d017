#pragma once

#include "apps/lab/attack/attacks.h"

namespace carina::lab
{

// Those who act on every object there is, under the true epoch of its ownership, as its owner
// would, and on one that is their own.

/// By actions and their heartbeats.
[[nodiscard]] std::unique_ptr<Attack> beginForeignActions(const Target& target);
/// By messages of the session's strategy: of use only where it is a relayed one.
[[nodiscard]] std::unique_ptr<Attack> beginForeignMessages(const Target& target);

} // namespace carina::lab
