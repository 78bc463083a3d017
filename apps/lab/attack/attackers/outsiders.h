#pragma once

#include "apps/lab/attack/attacks.h"

namespace carina::lab
{

// Those who never take part.

/// Sends ClientHellos without a cookie, from one address.
[[nodiscard]] std::unique_ptr<Attack> beginClientHellos(const Target& target);
/// Opens paths over which nobody comes in.
[[nodiscard]] std::unique_ptr<Attack> beginIdlePaths(const Target& target);
/// Sends over paths over which nobody takes part, and opens others for those that are ended.
[[nodiscard]] std::unique_ptr<Attack> beginStrangers(const Target& target);

} // namespace carina::lab
