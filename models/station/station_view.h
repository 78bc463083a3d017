#pragma once

#include "engine/lungs/mechanics/lung_pair.h"
#include "engine/net/node/session_node.h"
#include "engine/session/respiration/respiration_follower.h"
#include "engine/session/station_tracking.h"

#include <functional>
#include <optional>

namespace carina
{

/// Where a viewer of a station takes its objects' poses from, in A.
struct ObjectPoses {
    /// The pose at a time; nothing for an object never seen.
    std::function<std::optional<PoseSample>(ObjectKind, SessionTime)> at;
    /// When the newest sample was true.
    std::function<std::optional<SessionTime>(ObjectKind)> newest;
};

/// The objects of the tracker here. @pre `tracking` outlives what is returned.
[[nodiscard]] ObjectPoses posesOf(const StationTracking& tracking);

/// The objects that others share at a station. @pre `node` outlives what is returned.
[[nodiscard]] ObjectPoses posesOf(const SessionNode& node, StationId station);

/// Everything of a station that moves, at one session time.
struct StationMoment {
    SessionTime time{};
    ChestShape breathing;               ///< as the mechanics have it
    ChestPose pose;                     ///< of the chest, which shows that
    Volume notDrawn{};                  ///< of the lungs, beyond what can be shown
    double exaggeration = 1.0;          ///< of the pose: at any other it shows more than is true
    std::optional<PoseSample> tube;     ///< X_AE; nothing while never seen
    std::optional<PoseSample> jaw;      ///< X_AJ
    std::optional<PoseSample> head;     ///< X_AH
    std::optional<ShownObject> patient; ///< X_AV; nothing while nobody acted on the patient
    std::optional<Duration> sampleAge;  ///< of the newest sample of the tube, at that time
};

/// Whether the virtual patient is drawn away from where it belongs.
[[nodiscard]] bool isAway(const StationMoment& moment);

/// One station as a viewer draws it: a pure function of the facts, the poses, the actions and a
/// time. All calls come from one thread.
class StationView
{
public:
    /// @pre all three outlive the view.
    StationView(const SessionNode& node, StationId station, const LungPair& lungs,
                ObjectPoses poses);

    /// Draws every departure of the chest from rest this many times as large, as far as it goes.
    /// 1 unless somebody asks; whoever shows it has to say so.
    void exaggerate(double factor) { m_exaggeration = factor; }

    /// The station at a time, with the pose of the chest for one level of detail.
    [[nodiscard]] StationMoment at(SessionTime t, std::size_t level) const;

    /// The station when a frame is lit, told on this machine's clock; before the session clock is
    /// set, the patient at rest and no objects.
    [[nodiscard]] StationMoment litAt(LocalTime lit, std::size_t level) const;

private:
    const SessionNode& m_node;
    StationId m_station;
    const LungPair& m_lungs;
    ObjectPoses m_poses;
    double m_exaggeration = 1.0;
    mutable RespirationFollower m_breathing; ///< what it keeps only makes it quick
};

} // namespace carina
