#pragma once

#include "apps/lab/attack/attacks.h"

namespace carina::lab
{

// Those who come in again and again.

/// One person under many names, a few of which are present at a time, each for a moment in which it
/// proposes all that its own budget has.
[[nodiscard]] std::unique_ptr<Attack> beginTurns(const Target& target);
/// Says Hello as one that has nothing of the log, for the host to send all of it again.
[[nodiscard]] std::unique_ptr<Attack> beginHungry(const Target& target);
/// Comes in under ever new names, each over a path of its own, until it has so many.
inline constexpr int kNewNames = 200;
[[nodiscard]] std::unique_ptr<Attack> beginNames(const Target& target);

} // namespace carina::lab
