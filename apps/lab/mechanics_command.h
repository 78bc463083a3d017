#pragma once

#include "apps/lab/command.h"

namespace carina::lab
{

/// `mechanics`: what the respiratory mechanics do with each condition, and how well they follow a
/// recorded ventilator.
[[nodiscard]] Command mechanicsCommand();

} // namespace carina::lab
