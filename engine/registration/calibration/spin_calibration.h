#pragma once

#include "engine/registration/calibration/turned_poses.h"

#include <optional>

namespace carina
{

/// The axis of a tool, such as the shaft of a stylus or the blade of a laryngoscope, found by
/// spinning the tool about it.
struct SpinCalibration {
    Vec3 axis_S = Vec3::Zero(); ///< unit vector in the tool's frame S
    Vec3 p_SC = Vec3::Zero();   ///< the point of the axis nearest to the origin of S, metres
    Angle wobble{};             ///< RMS angle of the axis from its mean in T
    double rms = 0.0;           ///< RMS distance of p_SC from its mean across the axis, metres
    int outliers = 0;           ///< number of rejected poses
    Angle uncertainty{};        ///< RMS error of axis_S, for independent wobble of the poses
    TurnCoverage coverage{};    ///< the direction that turned least is the axis
    /// Why the axis must not be used, although the poses determine one: ToolMoved where it wobbled
    /// by more than SpinSettings::largestWobble.
    std::optional<Error> refusal{};
};

/// The limits of a spin calibration.
struct SpinSettings {
    Angle outlierLimit = degrees(3.0); ///< a pose whose axis deviates more is rejected
    /// Smallest RMS turn of the directions across the axis; 20 degrees correspond to a spin of 35
    /// degrees to either side.
    Angle leastTurn = degrees(20.0);
    Angle largestWobble = degrees(1.5);
};

/// Finds the axis a that all rotations leave unchanged: the unit vector that minimises
///
///     sum_i | (R_TS_i - R) a |^2        R: mean of all R_TS_i
///
/// which is the eigenvector of PoseMeans::turn with the smallest eigenvalue, over the inliers
/// (consensus). The tool may slide along its axis. With n poses the RMS error of the axis is wobble
/// / sqrt(2n) sqrt(1/t1^2 + 1/t2^2), where t1 and t2 are the turns across it.
///
/// @param X_TS      poses of the tool while it was spun about an axis that did not move
/// @param p_S_ahead a point ahead, such as the tip: the sign of the axis is chosen towards it
/// @returns TooFewPoses below ten; NotEnoughSpin where the tool was turned too little about its
///          axis; ToolMoved where fewer than ten poses or fewer than half are inliers; NotFinite
///          and OutOfRange as calibratePivot.
[[nodiscard]] Result<SpinCalibration> calibrateSpin(std::span<const RigidTransform> X_TS,
                                                    const Vec3& p_S_ahead,
                                                    const SpinSettings& settings = {});

} // namespace carina
