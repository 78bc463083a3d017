#pragma once

#include "engine/core/session_time.h"
#include "engine/lungs/respiratory_fold.h"
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

/// What was decided about the respiratory mechanics of one patient over the session, besides what a
/// BreathingTimeline has. Before the first changes a healthy child of 12 years, 150 cm and 40 kg
/// breathes without help.
///
/// Changes may come in any order; of two of one kind for the same time the later one holds. Breaths
/// and checkpoints come in the order of their facts.
class RespirationTimeline
{
public:
    void setBuild(SessionTime from, const PatientBuild& build) { m_build.set(from, build); }
    void setCondition(SessionTime from, const LungCondition& condition)
    {
        m_condition.set(from, condition);
    }
    void setVentilator(SessionTime from, const VentilatorSettings& settings)
    {
        m_ventilator.set(from, settings);
    }
    void setTube(SessionTime from, Length innerDiameter) { m_tube.set(from, innerDiameter); }
    /// One that began later than it is heard of, or more than kLongestNews before, is not believed.
    void addBreath(const HeardBreath& breath);
    /// One that is not later than the last is not taken.
    void addCheckpoint(const RespirationState& checkpoint);

    /// The settings in force at t, with those of the breaths beside them.
    [[nodiscard]] RespiratorySettings settingsAt(SessionTime t,
                                                 const BreathingPattern& pattern) const;
    /// The first change after t; the end of all time where there is none.
    [[nodiscard]] SessionTime changeAfter(SessionTime t) const;
    /// In ascending order of `heard`.
    [[nodiscard]] std::span<const HeardBreath> breaths() const { return m_breaths; }
    /// The last at or before t; nullptr where there is none.
    [[nodiscard]] const RespirationState* checkpointBefore(SessionTime t) const;

private:
    ParameterTimeline<PatientBuild> m_build{{metres(1.5), 40.0, 12.0, Sex::Female}};
    ParameterTimeline<LungCondition> m_condition{{}};
    ParameterTimeline<VentilatorSettings> m_ventilator{{}};
    ParameterTimeline<Length> m_tube{{}};
    std::vector<HeardBreath> m_breaths;
    std::vector<RespirationState> m_checkpoints;
};

inline constexpr Duration kLongestNews = std::chrono::seconds{5};

} // namespace carina
