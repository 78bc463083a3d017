#pragma once

#include "engine/tracking/markers/marker_pose.h"

namespace carina
{

/// Which of the markers of a probe the points are that a passive tracker sees without order, among
/// them points of other tools and reflections.
///
/// Three points, those that span the largest triangle first, are compared with all triples of
/// markers whose distances agree. Each triple gives a pose, which puts the other markers at places;
/// the points near these are theirs. The assignment with the most points is taken, of those with as
/// many the one that fits best. Three points alone count only where no other is near. The rotation
/// of a fit is always proper, and a pose in which a marker would face away from the tracker is
/// refused: so the mirror image of a probe is not taken for it, nor a flat one that is turned over.
///
/// @param p_TQ what is seen, metres; at most kMostPoints
/// @returns the markers that were found, in ascending order of their index.
///          TooFewLandmarks below the fewest points; DegenerateLandmarks where no assignment fits,
///          or several that differ fit as well, as for a symmetric probe.
[[nodiscard]] Result<std::vector<SeenMarker>> searchMarkers(const Probe& probe,
                                                            std::span<const Vec3> p_TQ);

inline constexpr std::size_t kMostPoints = 64;

} // namespace carina
