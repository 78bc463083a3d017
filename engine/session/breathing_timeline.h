#pragma once

#include "engine/core/session_time.h"
#include "engine/core/units.h"
#include "engine/lungs/breathing_pattern.h"

namespace carina
{

/// Rate, tidal volume and inspiratory fraction of one patient over the session, and whether the
/// session runs.
///
/// The breath phase is the integral of the rate over the running time, so that a change of rate
/// never makes the volume jump and a pause holds the lungs where they are. Tidal volume and
/// inspiratory fraction in force at the start of a breath hold for that breath.
class BreathingTimeline
{
public:
    void setRate(SessionTime from, Frequency rate);
    void setTidalVolume(SessionTime from, Volume tidalVolume);
    void setInspiratoryFraction(SessionTime from, double fraction);
    void setRunning(SessionTime from, bool running);

    /// The settings in force at t (what a console shows).
    [[nodiscard]] BreathingPattern settingsAt(SessionTime t) const;
    /// Breaths since the start, whole and part.
    [[nodiscard]] double breathsAt(SessionTime t) const;
    /// Gas above functional residual capacity at t, both lungs together.
    [[nodiscard]] Volume inspiredAt(SessionTime t) const;
};

} // namespace carina
