#pragma once

#include "apps/lab/attack/attacks.h"

namespace carina::lab
{

// Those who keep within what is allowed to one, and send all that is.

/// Tells where its tube was shown a thousand times a second, for the host to send it to everybody.
[[nodiscard]] std::unique_ptr<Attack> beginShowing(const Target& target);
/// One person under many names, each of which keeps within its own budget.
[[nodiscard]] std::unique_ptr<Attack> beginCrowd(const Target& target);

} // namespace carina::lab
