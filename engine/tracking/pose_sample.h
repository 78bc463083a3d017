#pragma once

#include "engine/core/session_time.h"
#include "engine/geometry/rigid_transform.h"

#include <cstdint>
#include <optional>

namespace carina
{

/// How well the device saw the object, from best to worst.
enum class Validity : std::uint8_t {
    Tracked,        ///< fully seen
    PartlyOccluded, ///< partly seen: the pose is valid, its error larger
    Lost,           ///< not seen: the pose is the last one known, not the current one
};

/// How a pose for a requested time was obtained.
enum class How : std::uint8_t {
    Exact,        ///< measured at that time
    Interpolated, ///< between two measurements
    Predicted,    ///< extrapolated beyond the newest measurement
};

/// Velocity of the object O in the frame F, in axes of F.
struct Motion {
    Vec3 v_FO = Vec3::Zero(); ///< of the origin of O, m/s
    Vec3 w_FO = Vec3::Zero(); ///< angular, rad/s
};

/// A pose with its time, validity and error.
///
/// F is the frame of the history that contains the sample (T for a tracker, A for a shared object),
/// O the object. A lost sample holds the last pose known, never the identity as a default.
struct PoseSample {
    SessionTime time{}; ///< at which the object had this pose
    RigidTransform X_FO{};
    std::optional<Motion> motion{}; ///< where the source provides it
    Validity validity = Validity::Tracked;
    double error = 0.0; ///< RMS fit error of the device, metres
    How how = How::Exact;
};

} // namespace carina
