#include "engine/vision/camera_model.h"

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

constexpr double kNearest = 1e-6; ///< metres before the camera
constexpr int kMostPixels = 20'000;
constexpr int kMostSteps = 30;
constexpr double kClose = 1e-12;

/// A distorted point of the plane at distance 1, and its derivative.
struct Distorted {
    Vec2 at;
    Eigen::Matrix2d slope;
};

Distorted distorted(const std::array<double, 5>& d, const Vec2& u)
{
    const auto& [k1, k2, p1, p2, k3] = d;
    const double x = u.x();
    const double y = u.y();
    const double r2 = u.squaredNorm();
    const double radial = 1.0 + r2 * (k1 + r2 * (k2 + r2 * k3));
    const double radialSlope = 2.0 * (k1 + r2 * (2.0 * k2 + r2 * 3.0 * k3)); // by r2, times 2
    Distorted result;
    result.at = {x * radial + 2.0 * p1 * x * y + p2 * (r2 + 2.0 * x * x),
                 y * radial + p1 * (r2 + 2.0 * y * y) + 2.0 * p2 * x * y};
    const double mixed = x * y * radialSlope + 2.0 * p1 * x + 2.0 * p2 * y;
    result.slope << radial + x * x * radialSlope + 2.0 * p1 * y + 6.0 * p2 * x, mixed, //
        mixed, radial + y * y * radialSlope + 6.0 * p1 * y + 2.0 * p2 * x;
    return result;
}

Vec2 flattened(const Vec3& p_TQ) { return {p_TQ.x() / -p_TQ.z(), p_TQ.y() / p_TQ.z()}; }

} // namespace

bool isUsable(const CameraModel& camera)
{
    const double side = std::max(camera.width, camera.height);
    const auto isFocal = [&](double f) { return f > 0.05 * side && f < 50.0 * side; };
    const auto isWithin = [](double c, int size) { return c > -size && c < 2.0 * size; };
    return camera.width > 0 && camera.height > 0 && side <= kMostPixels && isFocal(camera.focal.x())
           && isFocal(camera.focal.y()) && isWithin(camera.centre.x(), camera.width)
           && isWithin(camera.centre.y(), camera.height)
           && std::ranges::all_of(camera.distortion, [](double k) { return std::abs(k) < 1e3; });
}

std::optional<Vec2> project(const CameraModel& camera, const Vec3& p_TQ)
{
    if (!(p_TQ.z() < -kNearest))
        return std::nullopt;
    return distorted(camera.distortion, flattened(p_TQ)).at.cwiseProduct(camera.focal)
           + camera.centre;
}

Eigen::Matrix<double, 2, 3> projectionSlope(const CameraModel& camera, const Vec3& p_TQ)
{
    const double away = -p_TQ.z();
    const Vec2 u = flattened(p_TQ);
    Eigen::Matrix<double, 2, 3> flat;
    flat << 1.0 / away, 0.0, u.x() / away, //
        0.0, -1.0 / away, u.y() / away;
    return camera.focal.asDiagonal() * distorted(camera.distortion, u).slope * flat;
}

Vec3 sightOf(const CameraModel& camera, const Vec2& pixel)
{
    const Vec2 wanted = (pixel - camera.centre).cwiseQuotient(camera.focal);
    Vec2 u = wanted;
    for (int step = 0; step < kMostSteps; ++step) {
        const Distorted now = distorted(camera.distortion, u);
        const Vec2 missing = wanted - now.at;
        if (missing.squaredNorm() < kClose * kClose)
            break;
        const double determinant = now.slope.determinant();
        if (!(determinant > 0.05))
            break; // beyond here the lens folds the picture over
        u += now.slope.inverse() * missing;
    }
    return {u.x(), -u.y(), -1.0};
}

} // namespace carina
