#pragma once

#include "engine/registration/calibration/turned_poses.h"

#include <optional>

namespace carina
{

/// The result of a pivot calibration: the tip of a stylus that was rotated with its tip in a divot.
struct PivotCalibration {
    Vec3 p_SQ = Vec3::Zero(); ///< the tip in the stylus frame S, metres
    Vec3 p_TQ = Vec3::Zero(); ///< the divot in the frame T of the poses, metres
    double rms = 0.0;         ///< RMS distance of the tip from the divot over the inliers, metres
    int outliers = 0;         ///< number of rejected poses
    /// Covariance of p_SQ, m^2, in axes of S, for equal and independent noise in all poses.
    Mat3 covariance_S = Mat3::Zero();
    TurnCoverage coverage{}; ///< of the inliers
    /// Why the tip must not be used, although the poses determine one: ToolMoved where fewer than
    /// half of them are inliers, or where rms is above PivotSettings::largestRms.
    std::optional<Error> refusal{};

    /// RMS error of the tip by the covariance, metres.
    [[nodiscard]] double uncertainty() const { return std::sqrt(covariance_S.trace()); }
};

/// The limits of a pivot calibration.
struct PivotSettings {
    Length outlierLimit = millimetres(3.0); ///< a pose with the tip further off is rejected
    /// Smallest RMS turn of every direction of the stylus (see TurnCoverage). Along the direction
    /// that turned least, the tip's error is the tracker's divided by the turn in radians.
    Angle leastTurn = degrees(5.0);
    /// Above this RMS the tip was not in a divot; a good stylus has 0.3 to 0.6 mm.
    Length largestRms = millimetres(1.5);
};

/// Finds the tip by the algebraic one-step method: the tip p_SQ and the divot p_TQ minimise
///
///     sum_i | X_TS_i * p_SQ - p_TQ |^2
///
/// which is linear in both, over the inliers (consensus). With n of these and
/// s^2 = sum_i |...|^2 / (3n - 6) the covariance of the tip is s^2 / n turn^-1 (PoseMeans::turn).
///
/// @param X_TS poses of the stylus while its tip did not move, in any frame T in which the divot is
///             fixed
/// @returns TooFewPoses below ten; NotEnoughMotion where the stylus was turned too little, or about
///          one axis only, so that the tip is undetermined (then the detail names the direction
///          that turned least); ToolMoved where fewer than ten poses are inliers; NotFinite for NaN
///          or infinity; OutOfRange for a coordinate of a kilometre or more.
[[nodiscard]] Result<PivotCalibration> calibratePivot(std::span<const RigidTransform> X_TS,
                                                      const PivotSettings& settings = {});

/// Whether poses with this coverage determine the tip.
/// @returns NotEnoughMotion, as calibratePivot.
[[nodiscard]] Result<void> checkTurns(const TurnCoverage& coverage, Angle leastTurn);

} // namespace carina
