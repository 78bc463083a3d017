#include "engine/anatomy/shapes/strand.h"

#include "engine/core/expects.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace carina
{

Strand::Strand(std::vector<StrandPoint> points) : m_points(std::move(points))
{
    CARINA_EXPECTS(m_points.size() >= 2);
}

double Strand::distance(const Vec3& p) const
{
    double nearest = std::numeric_limits<double>::infinity();
    std::size_t piece = 0;
    double share = 0.0;
    for (std::size_t i = 0; i + 1 < m_points.size(); ++i) {
        const Vec3 step = m_points[i + 1].p - m_points[i].p;
        const Vec3 from = p - m_points[i].p;
        const double t = std::clamp(from.dot(step) / step.squaredNorm(), 0.0, 1.0);
        const double squared = (from - t * step).squaredNorm();
        if (squared < nearest) {
            nearest = squared;
            piece = i;
            share = t;
        }
    }
    const StrandPoint& a = m_points[piece];
    const StrandPoint& b = m_points[piece + 1];
    const Vec3 off = p - a.p - share * (b.p - a.p);
    const double across = off.dot((a.thinAxis + share * (b.thinAxis - a.thinAxis)).normalized());
    const double aside = std::sqrt(std::max(nearest - across * across, 0.0));
    const double wide = a.wide + share * (b.wide - a.wide);
    const double thin = a.thin + share * (b.thin - a.thin);
    return roundedMax(std::abs(across) - thin, aside - wide, thin);
}

Box Strand::bounds() const
{
    Box box;
    for (const StrandPoint& point : m_points) {
        const Vec3 reach = Vec3::Constant(std::max(point.wide, point.thin));
        box.include(point.p - reach);
        box.include(point.p + reach);
    }
    return box;
}

ImplicitShape Strand::shape() const
{
    return {bounds(), [strand = *this](const Vec3& p) { return strand.distance(p); }};
}

std::vector<Vec3> smoothLine(const Vec3& from, const Vec3& leaving, const Vec3& to,
                             const Vec3& arriving, int pieces)
{
    std::vector<Vec3> line;
    for (int i = 0; i < pieces; ++i) {
        const double t = double(i) / pieces;
        const double t2 = t * t;
        const double t3 = t2 * t;
        line.emplace_back((2.0 * t3 - 3.0 * t2 + 1.0) * from + (t3 - 2.0 * t2 + t) * leaving
                          + (3.0 * t2 - 2.0 * t3) * to + (t3 - t2) * arriving);
    }
    return line;
}

std::vector<Vec3> smoothThrough(std::span<const Vec3> points, int pieces)
{
    CARINA_EXPECTS(points.size() >= 2);
    std::vector<Vec3> line;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const Vec3& before = points[i > 0 ? i - 1 : 0];
        const Vec3& after = points[std::min(i + 2, points.size() - 1)];
        const auto piece = smoothLine(points[i], 0.5 * (points[i + 1] - before), points[i + 1],
                                      0.5 * (after - points[i]), pieces);
        line.insert(line.end(), piece.begin(), piece.end());
    }
    line.push_back(points.back());
    return line;
}

double tubeDistance(const Vec3& p, std::span<const Vec3> line, std::span<const double> radii)
{
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
        nearest = std::min(nearest, rodDistance(p, line[i], line[i + 1], radii[i], radii[i + 1]));
    return nearest;
}

} // namespace carina
