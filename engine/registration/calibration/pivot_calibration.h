#pragma once

#include "engine/registration/calibration/turned_poses.h"

namespace carina
{

/// Where a stylus has its tip, found by turning it about its tip in a divot.
struct PivotCalibration {
    Vec3 p_SQ = Vec3::Zero(); ///< the tip in the stylus frame S, metres
    Vec3 p_TQ = Vec3::Zero(); ///< the divot in the frame T of the poses, metres
    double rms = 0.0;         ///< root mean square distance of the tips from the divot, metres
    int outliers = 0;         ///< poses left out
    /// Of p_SQ, m^2 in axes of S: of equal and independent noise in all positions of the tip.
    Mat3 covariance_S = Mat3::Zero();
    TurnCoverage coverage{}; ///< of the poses that were not left out

    /// RMS error of the tip that the covariance tells, metres.
    [[nodiscard]] double uncertainty() const { return std::sqrt(covariance_S.trace()); }
};

struct PivotSettings {
    Length outlierLimit = millimetres(3.0); ///< a tip further from the divot is left out
    /// RMS turn that every direction of the stylus has to make: the tip is 1 / turn times as
    /// uncertain along the direction that turned least as the tracker.
    Angle leastTurn = degrees(5.0);
    /// More was no tip in a divot: a good stylus leaves 0.3 to 0.6 mm.
    Length largestRms = millimetres(1.5);
};

/// Finds the tip by the algebraic one-step method: the tip p_SQ and the divot p_TQ minimise
///
///     sum_i | X_TS_i * p_SQ - p_TQ |^2
///
/// which is linear in both, over the poses that agree about the tip (consensus). With n of these
/// and s^2 = sum_i |...|^2 / (3n - 6) the covariance of the tip is s^2 / n turn^-1 (PoseMeans).
///
/// @param X_TS poses of the stylus while its tip stood still, in any frame that the divot stood
///             still in.
/// @returns TooFewPoses below ten; NotEnoughMotion where the stylus was turned too little, or about
///          one axis only, so that the tip is undetermined: the detail names the direction of the
///          stylus that turned least; ToolMoved where fewer than ten or than half of the poses
///          agree, or these leave too large an RMS; NotFinite for NaN or infinity; OutOfRange for a
///          kilometre or more.
[[nodiscard]] Result<PivotCalibration> calibratePivot(std::span<const RigidTransform> X_TS,
                                                      const PivotSettings& settings = {});

/// Whether poses with such a coverage tell a tip.
/// @returns NotEnoughMotion, as calibratePivot.
[[nodiscard]] Result<void> checkTurns(const TurnCoverage& coverage, Angle leastTurn);

} // namespace carina
