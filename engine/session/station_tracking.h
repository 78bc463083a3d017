#pragma once

#include "engine/geometry/rigid_transform.h"
#include "engine/tracking/tracker.h"

#include <functional>
#include <memory>
#include <mutex>
#include <optional>

namespace carina
{

/// Registration of a station's tracker to its patient.
struct StationRegistration {
    /// The tracker in the anatomy, as long as neither manikin nor tracker moves.
    RigidTransform X_AT;
    /// The anatomy in the frame J of the chin probe, with the mouth closed; nothing without this
    /// probe.
    std::optional<RigidTransform> X_JA{};
    /// The anatomy in the frame B of the body probe, X_BM * X_MA; nothing without a probe on the
    /// torso.
    std::optional<RigidTransform> X_BA{};
    /// The connector of the tube in the frame N of its markers; nothing where it is not calibrated:
    /// then the frame of the markers is taken for that of the connector.
    std::optional<RigidTransform> X_NE{};
    std::optional<RigidTransform> X_NL{}; ///< likewise the blade of the laryngoscope
};

/// How motion of the chin probe is interpreted; one probe alone cannot distinguish the two.
enum class ChinMotion : std::uint8_t {
    OfJaw,     ///< the manikin lies still and the mouth opens
    OfManikin, ///< the mouth is closed and the manikin is moved
};

/// How the pose of the patient is determined.
enum class MotionAssumption : std::uint8_t {
    BodyProbe,        ///< from the probe on the torso, without assumption
    ChinMovesManikin, ///< from the chin probe, with the mouth assumed closed
    ChinMovesJaw,     ///< manikin and tracker are assumed static; the chin probe moves the jaw
    Static,           ///< manikin and tracker are assumed static
};

/// The tools of one station's tracker, in the frame A of its patient.
///
/// With a body probe B the frame A moves with that probe; then the tracker may be moved as well,
/// and the chin probe gives the motion of the jaw alone:
///
///     X_AO = X_AB * X_BT * X_TO     and of the mandible X_AB * X_BT * X_TJ * X_JA
///
/// Without a body probe, with ChinMotion::OfJaw, the manikin is assumed static:
///
///     X_AO = X_AT * X_TO
///
/// and the pose of the jaw tool is that of the mandible, the frame fixed to it that coincides with
/// A while the mouth is closed: X_AT * X_TJ * X_JA. With ChinMotion::OfManikin the manikin moves
/// with the chin probe, and the mandible is in its closed position:
///
///     X_AO = X_AJ * X_JT * X_TO
///
/// The poses of tube and laryngoscope are those of connector and blade, where these are calibrated.
///
/// The tracker is shared: with another patient before it, the next StationTracking takes it over
/// while it runs, and those who still read poses of the patient before keep it, too.
///
/// All functions may be called from any thread.
class StationTracking
{
public:
    StationTracking(std::shared_ptr<Tracker> tracker, const StationRegistration& registration);

    /// @returns TrackerFailed; the detail says what to check.
    [[nodiscard]] Result<void> start();

    /// After return no sample arrives and the session clock is not read. Has no effect when not
    /// started.
    void stop() { m_tracker->stop(); }

    /// Replaces the registration, as after the manikin was moved.
    void takeRegistration(const StationRegistration& registration);

    /// Sets how motion of the chin probe is interpreted. On a change back to OfJaw the manikin
    /// stays where the probe was last seen.
    /// @returns false, and changes nothing, for a station without a chin probe or with a body
    ///          probe.
    bool takeChinMotion(ChinMotion motion);
    [[nodiscard]] ChinMotion chinMotion() const;
    [[nodiscard]] bool hasChinProbe() const;
    [[nodiscard]] bool hasBodyProbe() const;
    [[nodiscard]] MotionAssumption motionAssumption() const;
    /// What keeps the tracker from tracking (Tracker::trouble()).
    [[nodiscard]] std::string trouble() const { return m_tracker->trouble(); }
    /// What it tracks with.
    [[nodiscard]] const Tracker& tracker() const { return *m_tracker; }
    /// The same, to be used for the next patient.
    [[nodiscard]] const std::shared_ptr<Tracker>& sharedTracker() const { return m_tracker; }
    /// The tracker's name of the tool; empty where it has no such tool.
    [[nodiscard]] std::string toolName(ToolRole role) const;
    /// Whether the tracker has a tool for this, seen or not.
    [[nodiscard]] bool hasTool(ToolRole role) const;

    /// X_A<tool> at a time, as by PoseHistory::at; nothing for a tool that the tracker lacks. A
    /// tool is lost while the probe that determines the pose of the manikin is lost.
    [[nodiscard]] std::optional<PoseSample> at(ToolRole role, SessionTime t) const;

    /// The same as it is to be drawn, by PoseHistory::shownAt.
    [[nodiscard]] std::optional<PoseSample> shownAt(ToolRole role, SessionTime t) const;

    /// The newest sample X_A<tool>, with its velocity for extrapolation.
    [[nodiscard]] std::optional<PoseSample> newest(ToolRole role) const;

private:
    struct Assumption {
        StationRegistration registration;
        ChinMotion chin = ChinMotion::OfJaw;
    };

    /// A probe that is fixed to the manikin, and the anatomy in its frame P.
    struct Carrier {
        ToolRole probe = ToolRole::Manikin;
        RigidTransform X_PA;
    };

    /// The pose of a tool in T.
    using ReadPose = std::function<std::optional<PoseSample>(const PoseHistory&)>;
    [[nodiscard]] std::optional<PoseSample> inAnatomy(ToolRole role, const ReadPose& read) const;
    [[nodiscard]] Assumption assumed() const;
    [[nodiscard]] std::optional<Carrier> carrier(const Assumption& assumption) const;
    [[nodiscard]] const PoseHistory* historyOf(ToolRole role) const;

    std::shared_ptr<Tracker> m_tracker;
    std::vector<TrackedTool> m_tools;
    mutable std::mutex m_mutex;
    Assumption m_assumption;
};

} // namespace carina
