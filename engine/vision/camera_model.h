#pragma once

#include "engine/geometry/vec.h"

#include <array>
#include <optional>

namespace carina
{

using Vec2 = Eigen::Vector2d;

/// How a camera takes the points before it to its picture: a pinhole with the distortion of Brown
/// (1966), as OpenCV writes it. The camera is at the origin of T, +x to the right of the picture,
/// +y up, and looks along -z (docs/frames.md). With x = p.x / -p.z, y = -p.y / -p.z, r^2 = x^2 +
/// y^2
///
///     x' = x (1 + k1 r^2 + k2 r^4 + k3 r^6) + 2 p1 x y + p2 (r^2 + 2 x^2)
///     y' = y (1 + k1 r^2 + k2 r^4 + k3 r^6) + p1 (r^2 + 2 y^2) + 2 p2 x y
///     pixel = (focal.x x' + centre.x, focal.y y' + centre.y)
///
/// The centre of the upper left pixel is (0, 0).
struct CameraModel {
    int width = 0; ///< of the picture, pixels
    int height = 0;
    Vec2 focal = Vec2::Zero(); ///< pixels
    Vec2 centre = Vec2::Zero();
    std::array<double, 5> distortion{}; ///< k1, k2, p1, p2, k3
};

/// Whether pictures can be made by it: a size, focal lengths and a centre of that order, and finite
/// numbers.
[[nodiscard]] bool isUsable(const CameraModel& camera);

/// Where the camera sees a point, in pixels; may lie outside the picture. std::nullopt for one that
/// is not before it.
[[nodiscard]] std::optional<Vec2> project(const CameraModel& camera, const Vec3& p_TQ);

/// How the pixel moves with the point: the derivative of project().
/// @pre the point is before the camera.
[[nodiscard]] Eigen::Matrix<double, 2, 3> projectionSlope(const CameraModel& camera,
                                                          const Vec3& p_TQ);

/// The direction (x, y, -1) in T in which the camera sees a pixel; the inverse of project(). Beyond
/// where the distortion can be inverted it is the nearest that was found.
[[nodiscard]] Vec3 sightOf(const CameraModel& camera, const Vec2& pixel);

} // namespace carina
