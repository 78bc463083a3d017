#pragma once

#include "engine/anatomy/laryngoscopy/laryngoscopy_path.h"
#include "engine/anatomy/shapes/tube.h"
#include "engine/core/session_time.h"
#include "evaluation/intubation/bent_tube.h"
#include "evaluation/intubation/hand_track.h"
#include "evaluation/intubation/motion_patient.h"

#include <memory>
#include <optional>
#include <vector>

namespace carina
{

/// What people do beside moving something.
enum class MotionAct : std::uint8_t {
    CuffInflated,
    CuffDeflated,
    StyletOut,
    BreathsBegin,
    BreathsEnd
};
struct MotionCommand {
    MotionAct act = MotionAct::CuffInflated;
    Duration at{}; ///< from the motion's start

    friend bool operator==(const MotionCommand&, const MotionCommand&) = default;
};

/// True poses at a moment.
struct MotionMoment {
    RigidTransform X_AE; ///< the tube's connector
    RigidTransform X_AL; ///< the laryngoscope
    RigidTransform X_AJ; ///< of the mandible in the frame of the head, the identity if shut
    HeadPosition head;
};

/// Where the tip of a tube truly is at a moment.
struct TrueTip {
    TipTarget target = TipTarget::Trachea; ///< whose way it is on
    double along = 0.0;                    ///< of that way in the surfaces, metres
    Vec3 p_A = Vec3::Zero();
};

/// The movements of a motion, each over time in seconds.
struct MotionTracks {
    /// Of the tip along its way, from the level of the teeth, metres.
    HandTrack tip{-0.09};
    /// -2: the blade is beside the face; -1: in front of the mouth; then LaryngoscopyStep: 0 at
    /// LaryngoscopyStep::Uvula to 3 at LaryngoscopyStep::Full.
    HandTrack blade{-2.0};
    HandTrack jaw{0.0};     ///< open, while no blade is there: share of the opening for a blade
    HandTrack lever{0.0};   ///< of the blade about the teeth, radians
    HandTrack flexion{0.0}; ///< of the neck, radians
    struct Turn {
        double from_s = 0.0;
        TipTarget target = TipTarget::Trachea;
    };
    std::vector<Turn> turns{{}}; ///< which way the tip goes, in the order of their times
};

/// What of a tube the walls of an airway change.
enum class TubeBending : std::uint8_t {
    Rigid, ///< nothing: it keeps its curve at rest and passes through them
    Elastic
};

/// How tube and blade are held through a whole motion.
struct MotionGrip {
    HandTremor tubeHand{};
    HandTremor bladeHand{};
    Angle roll{};                 ///< of the tube about the line from teeth to tip
    Vec3 corner_A = Vec3::Zero(); ///< of the tube from the midline, where it passes the teeth
    Length lift = kUsualLift;
    TubeBending bending = TubeBending::Rigid;
};

/// Somebody's hands in one intubation of one patient: a pure function of time.
///
/// The tip of the tube lies on its way through the patient as jaw and neck have taken that, but for
/// the hand's tremor, and its centreline passes through a second place, 4 cm of the way before the
/// tip until that lies at the teeth, and from then on there. A rigid one has its curve at rest,
/// that of a patient's tube (TubeShape). An elastic one bends between both places as the walls of
/// the way let it (bentTube), and has that curve in front of them. A bent neck takes the connector
/// with the head, as a tube that is fixed to the face; the tube in the patient bends with it and
/// keeps its length from the teeth to the tip.
class IntubationMotion
{
public:
    /// @returns OutOfRange where the tube does not reach from its tip out of the mouth, at one of
    ///          the moments that are looked at (all 50 ms)
    [[nodiscard]] static Result<IntubationMotion> make(std::shared_ptr<const MotionPatient> patient,
                                                       TubeShape tube, const Blade& blade,
                                                       MotionTracks tracks, MotionGrip grip,
                                                       std::vector<MotionCommand> commands,
                                                       Duration length);

    [[nodiscard]] MotionMoment at(Duration t) const;
    // Of that what is found without the tube.
    [[nodiscard]] RigidTransform laryngoscopeAt(Duration t) const;
    [[nodiscard]] HeadPosition headAt(Duration t) const;
    /// The tube's centre line in A from the connector to the tip, in the neutral position of the
    /// head.
    [[nodiscard]] std::vector<Vec3> tubeLine(Duration t) const;
    [[nodiscard]] TrueTip tipAt(Duration t) const;
    /// The tip of the blade, from the plane through the upper incisors across the way there, into
    /// the mouth.
    [[nodiscard]] Length bladePastTeeth(Duration t) const;
    /// Of the tip, along the tube, from the place nearest to the incisors; 0 in front of them.
    [[nodiscard]] Length depthAtTeeth(Duration t) const;
    /// Of the tip, along its way; negative beyond. @pre its way passes the carina
    [[nodiscard]] Length tipAboveCarina(Duration t) const;

    [[nodiscard]] Duration length() const { return m_length; }
    [[nodiscard]] const std::vector<MotionCommand>& commands() const { return m_commands; }
    [[nodiscard]] const MotionPatient& patient() const { return *m_patient; }
    [[nodiscard]] const TubeShape& tube() const { return m_tube; }
    [[nodiscard]] const Blade& blade() const { return m_blade; }

private:
    static constexpr int kBladePoses = 50;

    IntubationMotion() = default;

    // All in the neutral position of the head, which takes tube and blade with it.
    [[nodiscard]] std::optional<BentTube> tubeAt(double seconds) const;
    [[nodiscard]] std::optional<BentTube> rigidTubeAt(double seconds) const;
    [[nodiscard]] std::optional<BentTube> elasticTubeAt(double seconds) const;
    [[nodiscard]] RigidTransform bladeAt(double seconds) const;
    [[nodiscard]] RigidTransform jawAt(double seconds) const;
    [[nodiscard]] TrueTip heldTipAt(double seconds) const;
    [[nodiscard]] TissueAroundWay tissueAt(double seconds) const;
    [[nodiscard]] NeckField neckAt(double seconds) const;
    struct BladePose {
        RigidTransform X_AL;
        RigidTransform X_AJ;
    };
    void tabulateBlade();
    [[nodiscard]] BladePose bladeInside(double value) const;
    [[nodiscard]] Vec3 inward_A() const;

    std::shared_ptr<const MotionPatient> m_patient;
    TubeShape m_tube;
    Blade m_blade;
    std::vector<BladePose> m_inside; ///< every 1 / kBladePoses of MotionTracks::blade from 0 on
    RigidTransform m_X_AL_ready;     ///< in front of the mouth
    RigidTransform m_X_AL_aside;     ///< beside the face
    MotionTracks m_tracks;
    MotionGrip m_grip;
    std::vector<MotionCommand> m_commands;
    Duration m_length{};
};

/// The tube with this length, straight on at its connector: one that is drawn is cut 5 cm in front
/// of the teeth. What is longer stays as it is.
[[nodiscard]] TubeShape lengthened(TubeShape tube, Length whole);

/// A tube of this size and length with the form of the airway at its usual depth.
/// @returns the errors of makeTube
[[nodiscard]] Result<TubeShape> motionTube(const AirwayLandmarks& airway, Length innerDiameter,
                                           Length whole);

/// How much of a tube is beyond the teeth while its tip is at a place of a way, at the fork or
/// beyond; nothing where the tube does not reach from there to the teeth.
[[nodiscard]] std::optional<Length> tubeInside(const MotionPatient& patient, const TubeShape& tube,
                                               TubeBending bending, const TipWay& way,
                                               double along);

/// A blade that is long enough for an airway: Macintosh 3 or 2, of infants Miller 1 or 0. The
/// bounds are of ours.
[[nodiscard]] const Blade& motionBlade(const UpperAirway& upper);

} // namespace carina
