#pragma once

#include "apps/lab/attack/attacks.h"

namespace carina::lab
{

// Those who want to be taken for a trainee who is present.

/// By the id of the fact with which that one came in.
[[nodiscard]] std::unique_ptr<Attack> beginImpostor(const Target& target);
/// By its number and name, without its token.
[[nodiscard]] std::unique_ptr<Attack> beginFalseToken(const Target& target);

} // namespace carina::lab
