#pragma once

#include "engine/geometry/rigid_transform.h"
#include "engine/tracking/markers/probe.h"

namespace carina
{

/// A marker of a probe as the tracker saw it.
struct SeenMarker {
    std::size_t marker = 0;   ///< index in the probe
    Vec3 p_TQ = Vec3::Zero(); ///< metres
};

/// The pose of a probe from its markers.
struct MarkerPose {
    RigidTransform X_TO;
    double rms =
        0.0; ///< of the distances of the markers used from where the pose puts them, metres
    std::vector<std::size_t>
        leftOut{}; ///< indices, in what was seen, of what is elsewhere than the pose puts it
};

/// The fewest markers that have to agree where others are left out. Three are not enough: their
/// mirror image is a turn of them.
inline constexpr std::size_t kFewestAgreeing = 4;

/// The pose of a probe whose markers are known one by one: the fit in closed form (fitRigid), in
/// which all count alike. Where a marker misfits by more than the probe allows, the pose is that of
/// the most markers that agree (consensus), of which there have to be more than half, and
/// kFewestAgreeing at least; the others are left out.
///
/// The mirror image of a probe is refused where all markers fit it, and where as many agree on it
/// as on the probe and fit it as well. Markers cannot be told from their mirror image, and are
/// not refused, where the image, laid over them as well as it goes, is off by no more (RMS) than
/// the probe allows a marker to be: such as those of a flat tool.
///
/// @pre the indices are those of markers of the probe, each once.
/// @returns TooFewLandmarks below the fewest that the probe needs; DegenerateLandmarks where the
///          markers are collinear, do not fit the probe, or fit its mirror image; the other errors
///          of fitRigid.
[[nodiscard]] Result<MarkerPose> markerPose(const Probe& probe, std::span<const SeenMarker> seen);

} // namespace carina
