#pragma once

#include "engine/core/session_time.h"
#include "engine/geometry/rigid_transform.h"

#include <cstdint>
#include <optional>

namespace carina
{

/// How well the device saw the object.
enum class Validity : std::uint8_t {
    Tracked,        ///< all that is needed was seen
    PartlyOccluded, ///< seen in part; the pose is good, its error larger
    Lost,           ///< not seen: the pose is where it was last, not where it is
};

/// How a pose for the time asked came about.
enum class How : std::uint8_t {
    Exact,        ///< measured at that time
    Interpolated, ///< between two measurements
    Predicted,    ///< beyond the newest measurement, by its velocity
};

/// Velocity of object O in frame F, in axes of F.
struct Motion {
    Vec3 v_FO = Vec3::Zero(); ///< of the origin of O, m/s
    Vec3 w_FO = Vec3::Zero(); ///< angular, rad/s
};

/// A pose that knows when it was true and how far it may be trusted.
///
/// F is the frame of the history the sample belongs to (T for a tracker, A for a shared object), O
/// the object. A lost sample carries the last pose known; it is never an identity by default.
struct PoseSample {
    SessionTime time{};
    RigidTransform X_FO{};
    std::optional<Motion> motion{}; ///< where the source knows it
    Validity validity = Validity::Tracked;
    double error = 0.0; ///< RMS fit error of the device, metres
    How how = How::Exact;
};

} // namespace carina
