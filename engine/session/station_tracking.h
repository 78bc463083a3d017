#pragma once

#include "engine/geometry/rigid_transform.h"
#include "engine/tracking/tracker.h"

#include <memory>
#include <mutex>
#include <optional>

namespace carina
{

/// How a station's tracker stands to its patient.
struct StationRegistration {
    RigidTransform X_AT; ///< the tracker in the anatomy, while the manikin lies where it lay
    /// The anatomy in the chin probe, with the mouth closed; none for a manikin without a probe.
    std::optional<RigidTransform> X_JA{};
    /// The anatomy in the body probe, X_BM * X_MA; none for a manikin without one on its torso.
    std::optional<RigidTransform> X_BA{};
};

/// What a motion of the chin probe is taken for. One probe cannot tell both.
enum class ChinMotion : std::uint8_t {
    OfJaw,     ///< the manikin lies still and the mouth opens
    OfManikin, ///< the mouth is closed and the manikin is moved
};

/// By what it is known where the patient is.
enum class MotionAssumption : std::uint8_t {
    BodyProbe,        ///< it goes with the probe on the torso; nothing is assumed
    ChinMovesManikin, ///< it goes with the chin probe, the mouth being closed
    ChinMovesJaw,     ///< manikin and tracker stay where they are; the chin probe moves the jaw
    Static,           ///< manikin and tracker stay where they are
};

/// The tools of one station's tracker, told in the frame A of its patient.
///
/// With a body probe B the manikin goes with it, and so does the frame in which everything is told;
/// then the tracker may be moved as well, and the chin probe tells of the jaw alone:
///
///     X_AO = X_AB * X_BT * X_TO     and of the mandible X_AB * X_BT * X_TJ * X_JA
///
/// Without one, while the chin's motion is the jaw's, the manikin stays where it was:
///
///     X_AO = X_AT * X_TO        the pose told of the jaw is that of the mandible, the frame fixed
///                               to it that coincides with A while the mouth is closed:
///                               X_AT * X_TJ * X_JA
///
/// While it is the manikin's, the manikin goes with the probe:
///
///     X_AO = X_AJ * X_JT * X_TO with the mandible in its place
///
/// All calls may come from any thread.
class StationTracking
{
public:
    StationTracking(std::unique_ptr<Tracker> tracker, const StationRegistration& registration);
    ~StationTracking() { stop(); }

    /// @returns TrackerFailed with what to look at.
    [[nodiscard]] Result<void> start();

    /// On return no sample arrives any more and the session clock is not read. Harmless when not
    /// started.
    void stop() { m_tracker->stop(); }

    /// Takes a new registration over, as of a manikin that was laid anew.
    void takeRegistration(const StationRegistration& registration);

    /// Takes the chin's motions for this from now on. When they are the jaw's again, the manikin
    /// stays where the probe was seen last.
    /// @returns false for a station without a chin probe, or with a body probe, which stays as it
    ///          is.
    bool takeChinMotion(ChinMotion motion);
    [[nodiscard]] ChinMotion chinMotion() const;
    [[nodiscard]] bool hasChinProbe() const;
    [[nodiscard]] bool hasBodyProbe() const;
    [[nodiscard]] MotionAssumption motionAssumption() const;
    /// As the tracker names the tool; empty where it has none.
    [[nodiscard]] std::string toolName(ToolRole role) const;

    /// X_A<tool> at a time, as PoseHistory::at answers it; nothing for a tool the tracker lacks.
    /// A tool is lost while the probe is that should tell where the manikin is.
    [[nodiscard]] std::optional<PoseSample> at(ToolRole role, SessionTime t) const;

    /// The newest sample X_A<tool>, with the motion that would carry it on.
    [[nodiscard]] std::optional<PoseSample> newest(ToolRole role) const;

private:
    struct Assumption {
        StationRegistration registration;
        ChinMotion chin = ChinMotion::OfJaw;
    };

    /// A probe that the manikin goes with, and the anatomy in it.
    struct Carrier {
        ToolRole probe = ToolRole::Manikin;
        RigidTransform X_PA;
    };

    [[nodiscard]] Assumption assumed() const;
    [[nodiscard]] std::optional<Carrier> carrier(const Assumption& assumption) const;
    [[nodiscard]] const PoseHistory* historyOf(ToolRole role) const;

    std::unique_ptr<Tracker> m_tracker;
    std::vector<TrackedTool> m_tools;
    mutable std::mutex m_mutex;
    Assumption m_assumption;
};

} // namespace carina
