#include "engine/anatomy/shapes/implicit_shape.h"

#include "engine/core/expects.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace carina
{

double roundedMin(double a, double b, double blend)
{
    const double h = std::max(blend - std::abs(a - b), 0.0);
    return std::min(a, b) - h * h / (4.0 * blend);
}

double roundedMax(double a, double b, double blend) { return -roundedMin(-a, -b, blend); }

double easedStep(double from, double to, double x)
{
    const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

double rodDistance(const Vec3& p, const Vec3& a, const Vec3& b, double ra, double rb)
{
    const Vec3 ab = b - a;
    const double t = std::clamp((p - a).dot(ab) / ab.squaredNorm(), 0.0, 1.0);
    return (p - a - t * ab).norm() - (ra + t * (rb - ra));
}

namespace
{

/// e is 1 on the surface; e (e - 1) / |grad| is the distance to first order (Quilez).
template <class Vector> double quadricDistance(const Vector& p, const Vector& radii)
{
    const double e = p.cwiseQuotient(radii).norm();
    const double slope = p.cwiseQuotient(radii.cwiseProduct(radii)).norm();
    return slope > 0.0 ? e * (e - 1.0) / slope : -radii.minCoeff();
}

} // namespace

double ellipsoidDistance(const Vec3& p, const Vec3& radii) { return quadricDistance(p, radii); }

double ellipseDistance(const Vec2& p, const Vec2& radii) { return quadricDistance(p, radii); }

double polygonDistance(const Vec2& p, std::span<const Vec2> corners)
{
    double nearest = std::numeric_limits<double>::infinity();
    bool inside = false;
    for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
        const Vec2& a = corners[i];
        const Vec2& b = corners[j];
        const Vec2 ab = b - a;
        const double t = std::clamp((p - a).dot(ab) / ab.squaredNorm(), 0.0, 1.0);
        nearest = std::min(nearest, (p - a - t * ab).norm());
        // A ray towards +x crosses this side.
        if ((a.y() > p.y()) != (b.y() > p.y())
            && p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
            inside = !inside;
    }
    return inside ? -nearest : nearest;
}

AlongLine alongLine(const Vec2& p, std::span<const Vec2> points)
{
    CARINA_EXPECTS(points.size() >= 2);
    AlongLine best{0.0, std::numeric_limits<double>::infinity()};
    double before = 0.0;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const Vec2 step = points[i + 1] - points[i];
        const double length = step.norm();
        const bool last = i + 2 == points.size();
        const double t = std::max((p - points[i]).dot(step) / length, 0.0);
        const double along = last ? t : std::min(t, length);
        const double off = (p - points[i] - along / length * step).norm();
        if (off < best.off)
            best = {before + along, off};
        before += length;
    }
    return best;
}

std::vector<Vec2> cornersCut(std::vector<Vec2> points, int times)
{
    for (int i = 0; i < times; ++i) {
        std::vector<Vec2> cut{points.front()};
        for (std::size_t k = 0; k + 1 < points.size(); ++k) {
            cut.emplace_back(0.75 * points[k] + 0.25 * points[k + 1]);
            cut.emplace_back(0.25 * points[k] + 0.75 * points[k + 1]);
        }
        cut.push_back(points.back());
        points = std::move(cut);
    }
    return points;
}

} // namespace carina
