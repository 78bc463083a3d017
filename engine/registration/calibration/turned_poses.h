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

/// How much each direction of a tool S was turned. The turn of a direction is the RMS distance of
/// its unit vector in T from the mean: the RMS angle in radians while small, 1 for a uniform full
/// circle.
///
/// A tool that was rotated about one axis only did not turn that axis: the tip's coordinate along
/// it is undetermined, and the tool has to be tilted so that this axis turns too.
struct TurnCoverage {
    std::array<Angle, 3> turns{};    ///< ascending
    std::array<Vec3, 3> dirs_S{};    ///< principal directions of the tool (unit), in the same order
    Vec3 dir_T_least = Vec3::Zero(); ///< mean of dirs_S[0] in T, unit
};

/// A pose X_TS of a tool as rotation matrix and origin, metres.
struct TurnedPose {
    Mat3 R_TS;
    Vec3 p_TS;
};

/// Means over poses. The tip p_SQ in a divot at p_TQ = R p_SQ + p is the solution of
///
///     turn * p_SQ = shift,  turn = mean (R_TS - R)^T (R_TS - R),  shift = -mean (R_TS - R)^T p_TS
struct PoseMeans {
    Mat3 R = Mat3::Zero(); ///< mean of R_TS; not a rotation matrix itself
    Vec3 p = Vec3::Zero(); ///< mean of p_TS
    Mat3 turn = Mat3::Zero();
    Vec3 shift = Vec3::Zero();

    [[nodiscard]] TurnCoverage coverage() const;
};

/// The smallest number of poses for a calibration.
inline constexpr std::size_t kFewestPoses = 10;

/// Converts and checks poses.
/// @returns TooFewPoses below kFewestPoses; NotFinite for NaN or infinity; OutOfRange for a
///          kilometre or more.
[[nodiscard]] Result<std::vector<TurnedPose>> turnedPoses(std::span<const RigidTransform> X_TS);

/// The means over the poses with these indices, or over all.
/// @pre there is at least one.
[[nodiscard]] PoseMeans meansOf(std::span<const TurnedPose> poses,
                                std::span<const std::size_t> which);
[[nodiscard]] PoseMeans meansOf(std::span<const TurnedPose> poses);

/// Text for error details: "2.5 degrees", "1.53 mm" and "(0.00 -0.60 0.80)".
[[nodiscard]] std::string inWords(Angle angle);
[[nodiscard]] std::string inWords(Length length);
[[nodiscard]] std::string inWords(const Vec3& direction);

} // namespace carina
