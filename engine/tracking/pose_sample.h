#pragma once

#include "engine/core/session_time.h"
#include "engine/core/units.h"
#include "engine/geometry/fit/motion_covariance.h"
#include "engine/geometry/rigid_transform.h"

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
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

/// How the variance of a pose grows when it is predicted: of one axis, after dt seconds,
/// sum_k c[k] dt^k.
struct ErrorGrowth {
    using Polynomial = std::array<double, 6>;
    Polynomial position{}; ///< m^2
    Polynomial rotation{}; ///< rad^2

    /// Root mean square of the whole error after dt seconds, from all three axes.
    [[nodiscard]] static double rmsAfter(double dt, const Polynomial& variance);
};

/// Velocity and acceleration of the object O in the frame F, in axes of F.
struct Motion {
    Vec3 v_FO = Vec3::Zero();     ///< of the origin of O, m/s
    Vec3 w_FO = Vec3::Zero();     ///< angular, rad/s
    Vec3 a_FO = Vec3::Zero();     ///< of the origin of O, m/s^2; 0 where it is not known
    Vec3 alpha_FO = Vec3::Zero(); ///< angular, rad/s^2; 0 where it is not known
    std::optional<ErrorGrowth> growth{};
};

/// How far a predicted pose is expected to be off, root mean squares.
struct PoseDeviation {
    Length position;
    Angle rotation;
};

/// Markers of a probe: bit i is that of its marker i.
using MarkerSet = std::bitset<64>;

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
    std::optional<PoseDeviation> deviation{}; ///< of a predicted pose, where it is known
    /// Of a measured pose, as a small motion of the points of O (Mat6), where its tracker tells it.
    std::optional<Mat6> covariance_O{};
    /// Of a measured pose, the markers that it was computed from, where its tracker tells them.
    /// Neither sent nor recorded.
    std::optional<MarkerSet> markers{};
};

inline double ErrorGrowth::rmsAfter(double dt, const Polynomial& variance)
{
    double sum = 0.0;
    for (auto c = variance.rbegin(); c != variance.rend(); ++c)
        sum = sum * dt + *c;
    return std::sqrt(3.0 * std::max(sum, 0.0));
}

} // namespace carina
