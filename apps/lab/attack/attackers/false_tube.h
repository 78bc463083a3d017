#pragma once

#include "apps/lab/attack/attacks.h"

namespace carina::lab
{

/// Shares a second "Tube" and streams it, in time and ahead of the session, as its own, as every
/// object that others have, and in the name of the trainee whose tube it is to replace.
[[nodiscard]] std::unique_ptr<Attack> beginFalseTube(const Target& target);

} // namespace carina::lab
