#include "apps/lab/soak/trend.h"

#include "engine/core/expects.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace carina::lab
{
namespace
{

TimedFigure meanOf(std::span<const TimedFigure> figures)
{
    TimedFigure sum;
    for (const TimedFigure& each : figures) {
        sum.time += each.time;
        sum.figure += each.figure;
    }
    const auto n = static_cast<double>(figures.size());
    return {sum.time / n, sum.figure / n};
}

double sumOfSquares(const std::vector<double>& values)
{
    double sum = 0.0;
    for (const double value : values)
        sum += value * value;
    return sum;
}

/// Of each with the next, 0 to 1.
double correlationOf(const std::vector<double>& deviations)
{
    double product = 0.0;
    for (std::size_t i = 1; i < deviations.size(); ++i)
        product += deviations[i - 1] * deviations[i];
    const double squares = sumOfSquares(deviations);
    return squares > 0.0 ? std::clamp(product / squares, 0.0, 1.0) : 0.0;
}

} // namespace

std::vector<TimedFigure> leastOfEach(std::span<const TimedFigure> figures, int parts)
{
    CARINA_EXPECTS(parts > 0);
    std::vector<TimedFigure> least;
    int part = -1;
    for (const TimedFigure& each : figures) {
        const double share =
            (each.time - figures.front().time) / (figures.back().time - figures.front().time);
        const int itsPart = std::min(static_cast<int>(share * parts), parts - 1);
        if (std::exchange(part, itsPart) != itsPart)
            least.push_back(each);
        else if (each.figure < least.back().figure)
            least.back() = each;
    }
    return least;
}

Trend trendOf(std::span<const TimedFigure> figures)
{
    CARINA_EXPECTS(figures.size() >= 3);
    const TimedFigure mean = meanOf(figures);
    double spread = 0.0;
    double common = 0.0;
    for (const TimedFigure& each : figures) {
        spread += (each.time - mean.time) * (each.time - mean.time);
        common += (each.time - mean.time) * (each.figure - mean.figure);
    }
    CARINA_EXPECTS(spread > 0.0);
    Trend trend{.slope = common / spread};
    std::vector<double> deviations;
    for (const TimedFigure& each : figures)
        deviations.push_back(each.figure - mean.figure - trend.slope * (each.time - mean.time));
    const double r = correlationOf(deviations);
    const double independent = static_cast<double>(figures.size()) * (1.0 - r) / (1.0 + r);
    // A line takes two of them away.
    const double variance = sumOfSquares(deviations) / std::max(1.0, independent - 2.0);
    trend.standardError = std::sqrt(variance / spread);
    return trend;
}

} // namespace carina::lab
