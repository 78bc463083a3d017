#pragma once

#include "engine/core/session_time.h"
#include "engine/lungs/mechanics/respiratory_fold.h"
#include "engine/session/parameter_timeline.h"

#include <span>
#include <vector>

namespace carina
{

/// A breath of the manikin, and when it may be heard of everywhere.
struct HeardBreath {
    SessionTime heard{};
    SessionTime began{};
};

/// A fold's state at a time.
struct RespirationState {
    SessionTime at{};
    RespiratoryState state;
};

/// What was decided about the breathing of one patient over the session, and whether the session
/// runs. Before the first changes a healthy child of 12 years, 150 cm and 40 kg breathes without
/// help as a BreathingPattern is made, on the back, and the session does not run.
///
/// Changes may come in any order; of two of one kind for the same time the later one holds. Breaths
/// and checkpoints come in the order of their facts.
class RespirationTimeline
{
public:
    /// @pre rate is finite and not negative.
    void setRate(SessionTime from, Frequency rate);
    void setTidalVolume(SessionTime from, Volume tidalVolume);
    /// @pre the fraction lies in 0.1..0.9.
    void setInspiratoryFraction(SessionTime from, double fraction);
    void setBuild(SessionTime from, const PatientBuild& build);
    void setCondition(SessionTime from, const LungCondition& condition);
    void setVentilator(SessionTime from, const VentilatorSettings& settings);
    void setTube(SessionTime from, Length innerDiameter);
    void setPosition(SessionTime from, BodyPosition position);
    void setRunning(SessionTime from, bool running);
    /// One that began later than it is heard of, or more than kLongestNews before, is not believed.
    void addBreath(const HeardBreath& breath);
    /// One that is not later than the last is not taken. A change from before it that is decided
    /// afterwards makes it void.
    void addCheckpoint(const RespirationState& checkpoint);

    /// The settings in force at t (what a console shows).
    [[nodiscard]] RespiratorySettings settingsAt(SessionTime t) const;
    [[nodiscard]] bool runsAt(SessionTime t) const { return m_running.at(t); }
    /// The first change of a setting or of running after t; the end of all time where there is
    /// none.
    [[nodiscard]] SessionTime changeAfter(SessionTime t) const;
    /// In ascending order of `heard`.
    [[nodiscard]] std::span<const HeardBreath> breaths() const { return m_breaths; }
    /// The last at or before t; nullptr where there is none.
    [[nodiscard]] const RespirationState* checkpointBefore(SessionTime t) const;
    /// From when on each change and each breath counts, in the order in which they were decided:
    /// whoever knows how many there were finds out what the new ones touch.
    [[nodiscard]] std::span<const SessionTime> decisions() const { return m_decisions; }

private:
    void decide(SessionTime from);

    ParameterTimeline<Frequency> m_rate{BreathingPattern{}.rate};
    ParameterTimeline<Volume> m_tidalVolume{BreathingPattern{}.tidalVolume};
    ParameterTimeline<double> m_inspiratoryFraction{BreathingPattern{}.inspiratoryFraction};
    ParameterTimeline<PatientBuild> m_build{{metres(1.5), 40.0, 12.0, Sex::Female}};
    ParameterTimeline<LungCondition> m_condition{{}};
    ParameterTimeline<VentilatorSettings> m_ventilator{{}};
    ParameterTimeline<Length> m_tube{{}};
    ParameterTimeline<BodyPosition> m_position{BodyPosition::Supine};
    ParameterTimeline<bool> m_running{false};
    std::vector<HeardBreath> m_breaths;
    std::vector<RespirationState> m_checkpoints;
    std::vector<SessionTime> m_decisions;
};

inline constexpr Duration kLongestNews = std::chrono::seconds{5};

} // namespace carina
