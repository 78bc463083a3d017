#pragma once

#include "engine/geometry/fit/fit_covariance.h"
#include "engine/registration/error/error_bound.h"
#include "engine/registration/error/localisation_error.h"

#include <cstdint>

namespace carina
{

/// The axes of the anatomy frame, as directions of the body.
enum class BodyAxis : std::uint8_t { LeftRight, FrontBack, HeadFeet };

/// The target registration error (TRE): the distance at a target between the drawn anatomy and its
/// true place.
struct TargetError {
    Mat3 covariance_A = Mat3::Zero();           ///< m^2
    Length rms;                                 ///< root mean square length of the error
    Length bound;                               ///< 95 % bound (errorBound)
    Vec3 weakest_A = Vec3::UnitX();             ///< unit: the direction of the largest variance
    BodyAxis weakestAxis = BodyAxis::LeftRight; ///< the axis nearest to weakest_A
};

/// The TRE at a target.
/// @param covariance_A of X_AM, see Mat6 (motion_covariance.h)
/// @param p_AQ the target, metres
/// @param degrees degrees of freedom of the FLE that covariance_A is based on: those of the
///                LocalisationError where it was estimated from residuals, so that the bound holds
///                in 95 % of registrations; kKnownExactly where it is taken as known
[[nodiscard]] TargetError targetError(const Mat6& covariance_A, const Vec3& p_AQ,
                                      double degrees = kKnownExactly);

} // namespace carina
