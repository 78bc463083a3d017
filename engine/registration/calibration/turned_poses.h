#pragma once

#include "engine/core/result.h"
#include "engine/core/units.h"
#include "engine/geometry/rigid_transform.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace carina
{

/// How much a tool S was turned, direction by direction. The turn of a direction of the tool is the
/// RMS way of its unit vector from the mean: radians while small, 1 for a uniform full circle.
///
/// A direction about which alone a tool was turned did not turn itself: it is the one of which the
/// tip along it stays unknown, and towards which the tool has to be leaned.
struct TurnCoverage {
    std::array<Angle, 3> turns{};    ///< ascending
    std::array<Vec3, 3> dirs_S{};    ///< unit directions of the tool, in the same order
    Vec3 dir_T_least = Vec3::Zero(); ///< the first, as it stood on average
};

/// A tool's pose as what calibrations compute with.
struct TurnedPose {
    Mat3 R_TS;
    Vec3 p_TS;
};

/// Means over poses, of which a tip in a divot at p_TQ = R p_SQ + p follows:
///
///     turn * p_SQ = shift,  turn = mean (R_TS - R)^T (R_TS - R),  shift = -mean (R_TS - R)^T p_TS
struct PoseMeans {
    Mat3 R = Mat3::Zero(); ///< of R_TS: no rotation itself
    Vec3 p = Vec3::Zero(); ///< of p_TS
    Mat3 turn = Mat3::Zero();
    Vec3 shift = Vec3::Zero();

    [[nodiscard]] TurnCoverage coverage() const;
};

/// Fewer poses calibrate nothing.
inline constexpr std::size_t kFewestPoses = 10;

/// Poses to compute with.
/// @returns TooFewPoses below kFewestPoses; NotFinite for NaN or infinity; OutOfRange for a
///          kilometre or more.
[[nodiscard]] Result<std::vector<TurnedPose>> turnedPoses(std::span<const RigidTransform> X_TS);

/// @param which indices of those that count; there are some.
[[nodiscard]] PoseMeans meansOf(std::span<const TurnedPose> poses,
                                std::span<const std::size_t> which);
[[nodiscard]] PoseMeans meansOf(std::span<const TurnedPose> poses);

/// "2.5 degrees", "1.53 mm" and "(0.00 -0.60 0.80)".
[[nodiscard]] std::string inWords(Angle angle);
[[nodiscard]] std::string inWords(Length length);
[[nodiscard]] std::string inWords(const Vec3& direction);

} // namespace carina
