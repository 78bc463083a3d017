#pragma once

#include "engine/geometry/fit/motion_covariance.h"
#include "engine/geometry/rigid_transform.h"
#include "engine/vision/camera_model.h"

#include <optional>
#include <span>

namespace carina
{

/// A corner of a body as a camera sees it.
struct SeenCorner {
    Vec3 p_BQ;
    Vec2 pixel;
};

/// A pose of a body, fitted to the corners seen.
struct FittedBody {
    RigidTransform X_TB;
    double rms = 0.0; ///< of the distances between corners seen and projected, pixels
    double squares = 0.0;
    Mat6 covariance_T = Mat6::Zero(); ///< see Mat6 (motion_covariance.h)
};

/// What a camera knows of a body from one picture.
struct BodyFit {
    FittedBody best;
    /// The other minimum, where there is one: for corners in one plane the pose that is tilted to
    /// the other side, the mirror image of the plane across the line of sight.
    std::optional<FittedBody> rival{};
    /// ln of how much likelier the best is than the rival, by their residuals: half the difference
    /// of the squares over the variance of a corner.
    double evidence = 0.0;
};

/// Standard deviation of a refined corner along each axis, pixels, where the residuals of a body do
/// not tell. An estimate of ours.
inline constexpr double kCornerNoise = 0.15;

/// The pose that minimises the sum of the squared distances between corners seen and projected, by
/// Levenberg and Marquardt, from each of the closed-form solutions (Collins and Bartoli 2014 in a
/// plane, Terzakis and Lourakis 2020 otherwise). Its covariance is that of the least squares,
/// s^2 (J^T J)^-1, where s^2 weighs kCornerNoise^2 as four degrees of freedom against the
/// residuals.
///
/// std::nullopt with fewer than four corners, or where no pose before the camera fits them.
[[nodiscard]] std::optional<BodyFit> fitBody(const CameraModel& camera,
                                             std::span<const SeenCorner> corners);

} // namespace carina
