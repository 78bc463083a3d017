#pragma once

#include "engine/geometry/vec.h"

#include <span>

namespace carina
{

/// A point at a time, in any frame F.
struct TimedPoint {
    double seconds = 0.0; ///< since the time at which the motion is wanted
    Vec3 p_F = Vec3::Zero();
};

/// Position and its derivatives at a time.
struct LocalMotion {
    Vec3 p_F = Vec3::Zero(); ///< smoothed, m
    Vec3 v_F = Vec3::Zero(); ///< m/s
    Vec3 a_F = Vec3::Zero(); ///< m/s^2
    Vec3 j_F = Vec3::Zero(); ///< m/s^3
};

inline constexpr std::size_t kLeastPointsOfCubic = 4;

/// The motion at time 0 by the cubic of least squares through the points. Where they are evenly
/// spaced about 0, its derivatives are those of Savitzky and Golay (Anal Chem 1964;36:1627); it
/// holds as well for points that are not evenly spaced, as where a tracker left some out.
/// @pre at least kLeastPointsOfCubic points, at different times; their times are not all far from 0
///      beside their spread
[[nodiscard]] LocalMotion motionAtZero(std::span<const TimedPoint> points);

} // namespace carina
