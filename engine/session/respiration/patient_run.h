#pragma once

#include "engine/lungs/drawing/chest_shape.h"
#include "engine/physiology/body_fold.h"
#include "engine/session/facts/facts.h"
#include "engine/session/respiration/respiration_timeline.h"

#include <array>
#include <optional>

namespace carina
{

/// Simulates a station's patient along the session: a RespiratoryFold, and beside it a BodyFold
/// that takes a step with every kRespiratoryStepsPerBodyStep of its steps. Every setting, pause,
/// dose and breath of the manikin is applied at its effect time. Steps start when the session first
/// runs, and continue after a pause when it runs again, so that every node that has the facts up to
/// a time has the same state at it, bit for bit. Settings decided before the first step hold from
/// the start.
///
/// The lungs are ventilated through tube and gas as they are then (ventilatedThrough). Of the
/// patient's own breathing drugs leave a share, and cords that are shut by spasm obstruct the
/// airway of a patient whose tube is not through them. Who coughs does so the harder the more tone
/// drugs leave. All three act in steps of kBodyShare, so that the lungs do not get other settings
/// with each step of the body.
///
/// A patient in whom no hypnotic and no relaxant acts (isAnaesthetised) does not cough: a session
/// about lungs, ventilator or the way of a tube needs none, and its patient is taken for
/// anaesthetised by other means.
class PatientRun
{
public:
    /// Starts from the last checkpoint at or before t, else before the first breath.
    PatientRun(const RespirationTimeline& timeline, SessionTime t)
        : PatientRun{timeline, timeline.checkpointBefore(t)}
    {
    }

    /// Advances to the last whole step at or before t. `timeline` is the same one as before, and
    /// may have grown. Of a longer time between two changes only the last kLongestCatchUp is
    /// simulated, as after a host was down for a night, because a screen would freeze meanwhile.
    /// Until the next checkpoint a node that simulated all of it may then be at a different phase
    /// of a breath.
    void advanceTo(const RespirationTimeline& timeline, SessionTime t);

    /// Session time at the end of the last step.
    [[nodiscard]] SessionTime at() const { return m_at; }
    [[nodiscard]] const RespiratoryFold& fold() const { return m_fold; }
    [[nodiscard]] const BodyFold& body() const { return m_body; }
    /// How far the cords are shut by spasm, 0 to 1, in steps of kBodyShare; 0 where a tube is
    /// through them.
    [[nodiscard]] double spasm() const { return m_influence.spasm; }
    /// When the present breath of bag or ventilator began, once it was delivered: more gas than
    /// the anatomical dead space has come in; with a tube in the oesophagus, whose gas no lung
    /// tells of, the time has passed in which it is blown in.
    [[nodiscard]] std::optional<SessionTime> deliveredBreath() const;
    /// What a bedside monitor measures.
    [[nodiscard]] Vitals vitals() const { return m_body.vitals(); }
    /// The state to draw.
    [[nodiscard]] ChestShape shape() const;
    /// The present state as facts for the log, in this order, for participants that join later.
    [[nodiscard]] std::array<FactBody, 3> checkpoint() const;

private:
    /// What people and the tube decide at a time, as each fold gets it.
    struct Settings {
        RespiratorySettings breathing;
        BodySettings body;
    };
    /// How the body acts on the breathing, in steps of kBodyShare.
    struct Influence {
        double breathingLeft = 1.0;
        double spasm = 0.0; ///< 0 where a tube is through the cords
        double cough = 0.0; ///< by the tone that is left

        friend bool operator==(const Influence&, const Influence&) = default;
    };

    PatientRun(const RespirationTimeline& timeline, const RespirationState* checkpoint);

    [[nodiscard]] static Settings settingsAt(const RespirationTimeline& timeline, SessionTime t);
    [[nodiscard]] Influence influence() const;
    [[nodiscard]] bool coughs() const;
    [[nodiscard]] RespiratorySettings influenced() const;
    void passTo(const RespirationTimeline& timeline, SessionTime t);
    void skipTo(const RespirationTimeline& timeline, SessionTime t);
    void take(const RespirationTimeline& timeline);
    void meetAnew(const RespirationTimeline& timeline);
    void give(const RespirationTimeline& timeline, SessionTime from);
    void followBody();
    void step(const RespirationTimeline& timeline);
    void hear(const RespirationTimeline& timeline);
    void forgetBreaths();

    SessionTime m_at;
    SessionTime m_heardTo; ///< breaths of the manikin that were heard by then are applied
    Settings m_settings;
    BodyFold m_body; ///< it has the doses from before m_at
    Influence m_influence;
    RespiratoryFold m_fold;
};

/// The most that is simulated between two changes: 30,000 steps.
inline constexpr Duration kLongestCatchUp = std::chrono::seconds{60};

/// Interval of checkpoints that the host puts into the log.
inline constexpr Duration kCheckpointEvery = std::chrono::seconds{10};

/// Steps in which what the body does to the breathing changes: of the whole breathing, and of shut
/// cords. Of ours: fine enough that no step is to be seen.
inline constexpr double kBodyShare = 1.0 / 64.0;

} // namespace carina
