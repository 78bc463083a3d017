#include "engine/scoring/motion/local_motion.h"

#include "engine/core/expects.h"

#include <algorithm>
#include <cmath>

namespace carina
{

/// Times are divided by the largest, without which the sums of their powers would differ by many
/// orders of magnitude.
LocalMotion motionAtZero(std::span<const TimedPoint> points)
{
    CARINA_EXPECTS(points.size() >= kLeastPointsOfCubic);
    double scale = 0.0;
    for (const TimedPoint& point : points)
        scale = std::max(scale, std::abs(point.seconds));
    CARINA_EXPECTS(scale > 0.0);
    Eigen::Matrix4d squares = Eigen::Matrix4d::Zero();
    Eigen::Matrix<double, 4, 3> products = Eigen::Matrix<double, 4, 3>::Zero();
    for (const TimedPoint& point : points) {
        const double t = point.seconds / scale;
        const Eigen::Vector4d powers{1.0, t, t * t, t * t * t};
        squares += powers * powers.transpose();
        products += powers * point.p_F.transpose();
    }
    const Eigen::Matrix<double, 4, 3> cubic = squares.ldlt().solve(products);
    LocalMotion motion;
    motion.p_F = cubic.row(0);
    motion.v_F = cubic.row(1) / scale;
    motion.a_F = 2.0 * cubic.row(2) / (scale * scale);
    motion.j_F = 6.0 * cubic.row(3) / (scale * scale * scale);
    return motion;
}

} // namespace carina
