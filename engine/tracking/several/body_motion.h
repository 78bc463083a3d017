#pragma once

#include "engine/core/units.h"
#include "engine/geometry/rigid_transform.h"
#include "engine/tracking/pose_sample.h"

#include <array>
#include <span>
#include <vector>

namespace carina
{

/// How much a body was turned and moved, as one device saw it.
struct BodyMotion {
    /// RMS about the mean, about the three axes of the motion: the one that it was turned about
    /// most first. They are perpendicular, and need not be those of any frame.
    std::array<Angle, 3> turned{};
    Length moved{}; ///< the largest extent of its probe's places along an axis of the device
};

/// The motion in poses X_FO of one body; none where there are no poses.
[[nodiscard]] BodyMotion bodyMotion(std::span<const RigidTransform> poses);

/// The poses of samples in which the body was seen.
[[nodiscard]] std::vector<RigidTransform> seenPoses(std::span<const PoseSample> samples);

} // namespace carina
