#pragma once

#include "engine/session/facts/registration_facts.h"

#include <QString>

namespace carina
{

/// The standing of a registration in a few words, after its mark: "✓ registered, 1.4 mm",
/// "▲ stale: stylus calibrated anew"; "–" without a tracker.
[[nodiscard]] QString standingText(const RegistrationStanding& standing);

/// One sentence on what is wrong and what to do; empty where nothing is.
[[nodiscard]] QString standingNotice(const RegistrationStanding& standing);

} // namespace carina
