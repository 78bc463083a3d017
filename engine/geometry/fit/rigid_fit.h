#pragma once

#include "engine/core/result.h"
#include "engine/core/units.h"
#include "engine/geometry/rigid_transform.h"

#include <span>
#include <vector>

namespace carina
{

/// One landmark Q, known in the anatomy model and touched on the manikin.
struct LandmarkPair {
    Vec3 p_AQ = Vec3::Zero(); ///< Q in the anatomy frame A, metres
    Vec3 p_MQ = Vec3::Zero(); ///< Q in the manikin frame M, metres
};

/// A registration and its residuals at its own landmarks. The fiducial registration error (FRE)
/// says little about the error elsewhere (TRE).
struct RigidFit {
    RigidTransform X_AM;
    std::vector<double> residuals{}; ///< |p_AQ - X_AM p_MQ| of each pair, metres, in their order
    double rms = 0.0;                ///< FRE: root of the mean squared residual, metres
};

/// Landmarks whose RMS distance from their mean along their main direction is less count as
/// coincident: a tracker's noise is of that size.
inline constexpr Length kSmallestExtent = millimetres(1.0);

/// Landmarks count as collinear where their second largest extent is below this share of the
/// largest: the rotation about their line is then undetermined. For exactly collinear points 30 cm
/// long, 0.35 mm of tracker noise makes a share of about 0.003.
inline constexpr double kCollinearShare = 0.01;

/// Fits the manikin to the anatomy: the X_AM that minimises
///
///     sum_i | p_AQ_i - X_AM * p_MQ_i |^2
///
/// in closed form, from the SVD of the cross-covariance (Arun, Huang, Blostein 1987). The rotation
/// is always proper (Umeyama 1991): noisy, coplanar or mirrored landmarks never yield a mirrored
/// anatomy. Errors that are known to differ are weighted by fitWeighted (weighted_fit.h).
///
/// @returns TooFewLandmarks below three pairs; NotFinite for NaN or infinity and OutOfRange for a
///          kilometre or more in either set; DegenerateLandmarks if either set is coincident or
///          (nearly) collinear, or if more than one rotation fits best, as when one set is the
///          mirror image of the other or landmarks were touched in another order.
[[nodiscard]] Result<RigidFit> fitRigid(std::span<const LandmarkPair> pairs);

} // namespace carina
