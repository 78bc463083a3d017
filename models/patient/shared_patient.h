#pragma once

#include "engine/net/node/session_node.h"

namespace carina
{

/// The virtual patient of a station as an object that participants act on; nullptr before it is
/// shared. If several are shared, the first one.
[[nodiscard]] const SharedObject* sharedPatient(const SessionState& state, StationId station);

/// Proposes to share it, owned by this node, unless it is shared already.
void sharePatient(SessionNode& node, StationId station, const std::string& name);

/// How far actions have moved an object from its original pose, in which it coincides with the
/// anatomy frame A: angle of the rotation, distance of the origin (for a patient the carina), and
/// scale.
struct Displacement {
    double turned_deg = 0.0;
    double moved_mm = 0.0;
    double size_percent = 100.0;
};
[[nodiscard]] Displacement displacementOf(const ActedPose& acted);

/// Whether each number of displacementOf is within 0.05 of its original value, so that it shows no
/// displacement when written with one decimal.
[[nodiscard]] bool isInItsPlace(const ActedPose& acted);

} // namespace carina
