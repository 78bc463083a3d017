#pragma once

#include "engine/registration/calibration/turned_poses.h"

namespace carina
{

/// Where a tool has its axis, such as the shaft of a stylus or the blade of a laryngoscope, found
/// by spinning it about that axis.
struct SpinCalibration {
    Vec3 axis_S = Vec3::Zero(); ///< unit, in the tool's frame S
    Vec3 p_SC = Vec3::Zero();   ///< the point of the axis nearest to the origin of S, metres
    Angle wobble{};             ///< RMS angle of the axis from its mean in T
    double rms = 0.0;           ///< RMS distance of p_SC from its mean across the axis, metres
    int outliers = 0;           ///< poses left out
    Angle uncertainty{};        ///< RMS error of axis_S, of independent wobbles
    TurnCoverage coverage{};    ///< the direction that turned least is the axis
};

struct SpinSettings {
    Angle outlierLimit = degrees(3.0); ///< a pose whose axis leans further is left out
    /// RMS turn of every direction across the axis: 20 degrees are made by 35 to either side.
    Angle leastTurn = degrees(20.0);
    Angle largestWobble = degrees(1.5);
};

/// Finds the axis a that all rotations leave where it is: the unit vector with the least
///
///     sum_i | (R_TS_i - R) a |^2,  R the mean of all R_TS_i
///
/// which is the eigenvector of PoseMeans::turn to its least eigenvalue, over the poses that agree
/// about it (consensus). The tool may slide along its axis meanwhile. With n poses the axis is
/// uncertain by wobble / sqrt(2n) sqrt(1/t1^2 + 1/t2^2), where t1 and t2 are the turns across it.
///
/// @param X_TS      poses of the tool while it was spun about an axis that stood still
/// @param p_S_ahead the axis points from the origin of S to the side on which this lies, as the tip
/// @returns TooFewPoses below ten; NotEnoughSpin where the tool was turned too little about its
///          axis, or not about one axis; ToolMoved where fewer than ten or than half of the poses
///          agree, or the axis wobbled too much; NotFinite and OutOfRange as calibratePivot.
[[nodiscard]] Result<SpinCalibration> calibrateSpin(std::span<const RigidTransform> X_TS,
                                                    const Vec3& p_S_ahead,
                                                    const SpinSettings& settings = {});

} // namespace carina
