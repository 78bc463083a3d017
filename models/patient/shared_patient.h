#pragma once

#include "engine/net/node/session_node.h"

namespace carina
{

/// The virtual patient of a station as an object that participants act on; nullptr before it is
/// shared. Of several the one that was shared first.
[[nodiscard]] const SharedObject* sharedPatient(const SessionState& state, StationId station);

/// Shares it, owned by this node, where nobody has yet.
void sharePatient(SessionNode& node, StationId station, const std::string& name);

/// How far actions have moved an object from its place, where it coincides with the anatomy frame
/// A. The angle is that of the rotation, the way that of the origin (for a patient the carina).
struct Displacement {
    double turned_deg = 0.0;
    double moved_mm = 0.0;
    double size_percent = 100.0;
};
[[nodiscard]] Displacement displacementOf(const ActedPose& acted);

/// Whether it lies where it belongs, as far as numbers with one decimal tell.
[[nodiscard]] bool isInItsPlace(const ActedPose& acted);

} // namespace carina
