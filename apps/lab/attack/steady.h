#pragma once

#include "apps/lab/attack/attacks.h"

namespace carina::lab
{

/// One person under eight names, each of which sends datagrams of every kind as fast as one may,
/// none of which has an effect: so that the host looks into each of them.
[[nodiscard]] std::unique_ptr<Attack> beginSteady(const Target& target);

} // namespace carina::lab
