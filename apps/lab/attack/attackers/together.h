#pragma once

#include "apps/lab/attack/attacks.h"

namespace carina::lab
{

/// All kinds that can act at the same time, each by an attacker of its own.
[[nodiscard]] std::unique_ptr<Attack> beginTogether(const Target& target);

} // namespace carina::lab
