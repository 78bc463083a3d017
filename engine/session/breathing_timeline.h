#pragma once

#include "engine/core/session_time.h"
#include "engine/core/units.h"
#include "engine/lungs/breathing_pattern.h"
#include "engine/session/parameter_timeline.h"

namespace carina
{

/// Rate, tidal volume and inspiratory fraction of one patient over the session, and whether the
/// session runs. Before the first changes it holds a BreathingPattern as made, and does not run.
///
/// The breath phase is the integral of the rate over the running time, so that a change of rate
/// never makes the volume jump and a pause holds the lungs where they are. Tidal volume and
/// inspiratory fraction in force at the start of a breath hold for that breath.
///
/// Changes may come in any order; of two of one kind for the same time the later one holds.
class BreathingTimeline
{
public:
    /// @pre rate is finite and not negative.
    void setRate(SessionTime from, Frequency rate);
    void setTidalVolume(SessionTime from, Volume tidalVolume);
    /// @pre the fraction lies in 0.1..0.9.
    void setInspiratoryFraction(SessionTime from, double fraction);
    void setRunning(SessionTime from, bool running);

    /// The settings in force at t (what a console shows).
    [[nodiscard]] BreathingPattern settingsAt(SessionTime t) const;
    [[nodiscard]] bool runsAt(SessionTime t) const { return m_running.at(t); }
    /// The first change of a setting or of running after t; the end of all time where there is
    /// none.
    [[nodiscard]] SessionTime changeAfter(SessionTime t) const;
    /// Breaths since the start, whole and part.
    [[nodiscard]] double breathsAt(SessionTime t) const;
    /// Gas above functional residual capacity at t, both lungs together.
    [[nodiscard]] Volume inspiredAt(SessionTime t) const;

private:
    void refreshSpeed(SessionTime from, SessionTime until);
    [[nodiscard]] SessionTime breathStart(double breath, SessionTime t) const;

    ParameterTimeline<Frequency> m_rate{BreathingPattern{}.rate};
    ParameterTimeline<Volume> m_tidalVolume{BreathingPattern{}.tidalVolume};
    ParameterTimeline<double> m_inspiratoryFraction{BreathingPattern{}.inspiratoryFraction};
    ParameterTimeline<bool> m_running{false};
    ParameterTimeline<double> m_speed{0.0}; ///< breaths per second: the rate while it runs, else 0
};

} // namespace carina
