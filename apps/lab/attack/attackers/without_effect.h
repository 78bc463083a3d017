#pragma once

#include "apps/lab/attack/attacks.h"

namespace carina::lab
{

// Those whose datagrams have no effect, so that the host looks into each of them in vain.

/// One person under eight names, each of which sends datagrams of every kind as fast as one may,
/// none of which has an effect.
[[nodiscard]] std::unique_ptr<Attack> beginSteady(const Target& target);
/// Sends what is no datagram: bytes at random.
[[nodiscard]] std::unique_ptr<Attack> beginGarbage(const Target& target);

} // namespace carina::lab
