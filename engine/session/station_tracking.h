#pragma once

#include "engine/geometry/rigid_transform.h"
#include "engine/tracking/tracker.h"

#include <memory>
#include <optional>

namespace carina
{

/// How a station's tracker stands to its patient.
struct StationRegistration {
    RigidTransform X_AT; ///< the tracker in the anatomy
    RigidTransform X_JA; ///< the anatomy in the chin probe, with the mouth closed
};

/// The tools of one station's tracker, told in the frame A of its patient.
///
/// The pose told of the jaw is that of the mandible: the frame fixed to it that coincides with A
/// while the mouth is closed, X_AT * X_TJ * X_JA. All others are those of the tool's own frame.
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

    /// X_A<tool> at a time, as PoseHistory::at answers it; nothing for a tool the tracker lacks.
    [[nodiscard]] std::optional<PoseSample> at(ToolRole role, SessionTime t) const;

    /// The newest sample X_A<tool>, with the motion that would carry it on.
    [[nodiscard]] std::optional<PoseSample> newest(ToolRole role) const;

private:
    [[nodiscard]] std::optional<PoseSample> told(ToolRole role,
                                                 std::optional<PoseSample> X_TO) const;
    [[nodiscard]] const PoseHistory* historyOf(ToolRole role) const;

    std::unique_ptr<Tracker> m_tracker;
    std::vector<TrackedTool> m_tools;
    StationRegistration m_registration;
};

} // namespace carina
