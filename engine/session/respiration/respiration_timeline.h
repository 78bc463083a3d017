#pragma once

#include "engine/core/session_time.h"
#include "engine/lungs/mechanics/respiratory_fold.h"
#include "engine/physiology/body_fold.h"
#include "engine/session/body/tube_timeline.h"
#include "engine/session/parameter_timeline.h"

#include <optional>
#include <span>
#include <vector>

namespace carina
{

/// A breath of the manikin, and the effect time of its fact.
struct HeardBreath {
    SessionTime heard{};
    SessionTime began{};
};

/// The state of a patient at a session time: of the breathing, and of the body at the same time.
struct RespirationState {
    SessionTime at{};
    RespiratoryState state;
    BodyState body{};
};

/// A dose of a drug, and the effect time of its fact.
struct GivenDose {
    SessionTime from{};
    DrugDose dose;

    friend bool operator==(const GivenDose&, const GivenDose&) = default;
};

/// Whether the patient's own breathing stops, and over what time it changes.
struct OwnBreathing {
    bool stopped = false;
    Duration over{};

    friend bool operator==(const OwnBreathing&, const OwnBreathing&) = default;
};

/// What was decided about the breathing, the gas, the drugs and the tube of one patient over the
/// session, and whether the session runs. Before the first change the patient is a healthy child of
/// 12 years, 150 cm and 40 kg, supine, breathing room air spontaneously by the default
/// BreathingPattern, without drugs and tube, and the session does not run.
///
/// Changes may be added in any order; of two of one kind at the same time the last one added holds,
/// but of doses both. Breaths and checkpoints are added in the order of their facts.
class RespirationTimeline
{
public:
    static constexpr std::size_t kMostCheckpoints = 8;
    /// Effect times of changes and breaths that are kept; of ours: far more than come between two
    /// looks of who follows a patient.
    static constexpr std::size_t kMostDecisions = 256;
    /// Doses that are told however long ago they were given; of ours.
    static constexpr std::size_t kMostDosesTold = 128;

    /// @pre rate is finite and not negative.
    void setRate(SessionTime from, Frequency rate);
    void setTidalVolume(SessionTime from, Volume tidalVolume);
    /// @pre the fraction lies in 0.1..0.9.
    void setInspiratoryFraction(SessionTime from, double fraction);
    void setBuild(SessionTime from, const PatientBuild& build);
    void setConditions(SessionTime from, const LungConditions& conditions);
    void setVentilator(SessionTime from, const VentilatorSettings& settings);
    /// The console's own setting of the tube (TubeTimeline::setOverride).
    void setTube(SessionTime from, const SetTube& tube);
    void noteIntubation(SessionTime from, const IntubationEvent& event, Length innerDiameter);
    void setCuff(SessionTime from, bool inflated);
    void setObstruction(SessionTime from, double share);
    void drawStylet(SessionTime from) { m_tube.drawStylet(from); }
    void setGas(SessionTime from, const GasSupply& gas);
    void give(SessionTime from, const DrugDose& dose);
    void setPosition(SessionTime from, BodyPosition position);
    /// Changes the share of own breathing evenly over the time, in steps of kStoppingStep, from
    /// what is left at `from`. Replaces what of an earlier change was still to come.
    void setOwnBreathing(SessionTime from, const OwnBreathing& breathing);
    void setBag(SessionTime from, const HandBag& bag);
    void setRunning(SessionTime from, bool running);
    /// Ignored where it began after `heard`, or more than kLongestNews before.
    void addBreath(const HeardBreath& breath);
    /// The parts of a checkpoint, in this order. The last one, without its capnograph, makes a
    /// checkpoint of them; one that does not follow those of the same time is ignored.
    void addBreathing(SessionTime at, const RespiratoryState& state);
    void addCapnograph(SessionTime at, const CapnographState& state);
    void addBody(SessionTime at, const BodyState& state);
    /// Ignored where it is not later than the last. A change with an earlier effect time that is
    /// added afterwards invalidates it. Only the last kMostCheckpoints are kept, and of the changes
    /// of settings those that have an effect from the first of these on: the state of a session is
    /// copied with each fact, and who draws looks back for seconds. So it is with breaths, and with
    /// doses beyond the last kMostDosesTold.
    void addCheckpoint(const RespirationState& checkpoint);

    /// Nobody looks back further than to this time: the first checkpoint that is kept, once earlier
    /// ones were dropped; SessionTime::min() until then.
    [[nodiscard]] SessionTime keptFrom() const
    {
        return m_checkpoints.size() < kMostCheckpoints ? SessionTime::min()
                                                       : m_checkpoints.front().at;
    }

    /// The settings in force at t (what a console shows), which is no earlier than the first
    /// checkpoint that is kept. They know no tube: what follows of it see ventilatedThrough.
    [[nodiscard]] RespiratorySettings settingsAt(SessionTime t) const;
    /// The tube as it is set and noted, cuff and stylet.
    [[nodiscard]] const TubeTimeline& tube() const { return m_tube; }
    /// TubeTimeline::placeAt in this patient.
    [[nodiscard]] TubePlace tubePlaceAt(SessionTime t) const
    {
        return m_tube.placeAt(t, m_build.at(t));
    }
    [[nodiscard]] GasSupply gasAt(SessionTime t) const { return m_gas.at(t); }
    /// The doses from one time on and before another, in ascending order.
    [[nodiscard]] std::span<const GivenDose> dosesWithin(SessionTime from,
                                                         SessionTime before) const;
    /// What was decided last about the patient's own breathing.
    [[nodiscard]] OwnBreathing ownBreathingAt(SessionTime t) const { return m_decided.at(t); }
    [[nodiscard]] bool runsAt(SessionTime t) const { return m_running.at(t); }
    /// The first dose or change of a setting or of running after t; SessionTime::max() where there
    /// is none.
    [[nodiscard]] SessionTime changeAfter(SessionTime t) const;
    /// In ascending order of `heard`; those of before the first checkpoint that is kept are gone.
    [[nodiscard]] std::span<const HeardBreath> breaths() const { return m_breaths; }
    /// Those that were heard after one time and until another, this one included.
    [[nodiscard]] std::span<const HeardBreath> breathsHeard(SessionTime after,
                                                            SessionTime until) const;
    /// The last valid checkpoint at or before t; nullptr where none is kept.
    [[nodiscard]] const RespirationState* checkpointBefore(SessionTime t) const;
    /// How many changes and breaths were added so far.
    [[nodiscard]] std::size_t decisions() const { return m_forgotten + m_decisions.size(); }
    /// From when on those have an effect that were added after the first `known` of them, of which
    /// a reader keeps the number; SessionTime::max() where there are none, and SessionTime::min()
    /// where so many were added since that not all are kept.
    [[nodiscard]] SessionTime effectSince(std::size_t known) const;

private:
    /// Of a checkpoint of which the body is still to come.
    struct CheckpointParts {
        SessionTime at;
        RespiratoryState breathing;
        std::optional<CapnographState> capnograph;
    };

    void decide(SessionTime from);
    void forgetBefore(SessionTime t);

    ParameterTimeline<Frequency> m_rate{BreathingPattern{}.rate};
    ParameterTimeline<Volume> m_tidalVolume{BreathingPattern{}.tidalVolume};
    ParameterTimeline<double> m_inspiratoryFraction{BreathingPattern{}.inspiratoryFraction};
    ParameterTimeline<PatientBuild> m_build{{metres(1.5), 40.0, 12.0, Sex::Female}};
    ParameterTimeline<LungConditions> m_conditions{{}};
    ParameterTimeline<VentilatorSettings> m_ventilator{{}};
    TubeTimeline m_tube;
    ParameterTimeline<GasSupply> m_gas{{}};
    ParameterTimeline<BodyPosition> m_position{BodyPosition::Supine};
    ParameterTimeline<OwnBreathing> m_decided{{}};
    ParameterTimeline<double> m_ownBreathing{1.0}; ///< share that is left
    ParameterTimeline<HandBag> m_bag{{}};
    ParameterTimeline<bool> m_running{false};
    std::vector<HeardBreath> m_breaths;
    std::vector<GivenDose> m_doses; ///< in ascending order
    std::vector<RespirationState> m_checkpoints;
    std::optional<CheckpointParts> m_parts;
    std::vector<SessionTime> m_decisions; ///< effect times of the latest, in the order of adding
    std::size_t m_forgotten = 0;          ///< number of those before
};

/// Longest time over which breathing may stop or go on again, and the steps in which it does.
inline constexpr Duration kLongestStopping = std::chrono::minutes{10};
inline constexpr Duration kStoppingStep = std::chrono::seconds{1};

/// Longest time from a breath of the manikin to its effect.
inline constexpr Duration kLongestNews = std::chrono::seconds{5};

} // namespace carina
