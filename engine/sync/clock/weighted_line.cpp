#include "engine/sync/clock/weighted_line.h"

#include "engine/core/expects.h"

#include <cmath>

namespace carina
{
namespace
{

struct LineSums {
    double weight = 0.0;
    double squaredWeight = 0.0;
    double x = 0.0; ///< weighted mean
    double y = 0.0; ///< weighted mean
    double xx = 0.0;
    double xy = 0.0;
    double yy = 0.0;
};

LineSums sumsOf(const std::vector<WeightedLine::Point>& points)
{
    LineSums sums;
    for (const auto& [x, y, weight] : points) {
        sums.weight += weight;
        sums.squaredWeight += weight * weight;
        sums.x += weight * x;
        sums.y += weight * y;
    }
    sums.x /= sums.weight;
    sums.y /= sums.weight;
    for (const auto& [x, y, weight] : points) {
        sums.xx += weight * (x - sums.x) * (x - sums.x);
        sums.xy += weight * (x - sums.x) * (y - sums.y);
        sums.yy += weight * (y - sums.y) * (y - sums.y);
    }
    return sums;
}

/// Variance of a point of weight 1 about the free line; the line takes two of the points.
double scatterOf(const LineSums& sums)
{
    const double points = sums.weight * sums.weight / sums.squaredWeight;
    if (points <= 2.0 || sums.xx <= 0.0)
        return sums.yy / sums.weight;
    const double residual = std::max(0.0, sums.yy - sums.xy * sums.xy / sums.xx);
    return residual / sums.weight * points / (points - 2.0);
}

} // namespace

WeightedLine::Fit WeightedLine::fit(double prior) const
{
    CARINA_EXPECTS(!m_points.empty());
    const LineSums sums = sumsOf(m_points);
    const double scatter = scatterOf(sums);
    const double held = sums.xx + scatter / (prior * prior);
    const double slope = held > 0.0 ? sums.xy / held : 0.0;
    const double points = sums.weight * sums.weight / sums.squaredWeight;
    const double ofSlope = held > 0.0 ? sums.x * sums.x * scatter / held : 0.0;
    return {sums.y - slope * sums.x, slope, std::sqrt(scatter / points + ofSlope)};
}

} // namespace carina
