#include "widgets/report/plot.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carina
{
namespace
{

template <class Coordinate>
PlotScale scaleOf(const Plot& plot, const PlotAxis& axis, Coordinate coordinate)
{
    double least = std::numeric_limits<double>::infinity();
    double greatest = -least;
    for (const PlotSeries& series : plot.series) {
        for (const auto* points : {&series.marks, &series.line}) {
            for (const QPointF& point : *points) {
                const double value = coordinate(point);
                if (!std::isfinite(value) || (axis.isLogarithmic && value <= 0.0))
                    continue;
                least = std::min(least, value);
                greatest = std::max(greatest, value);
            }
        }
    }
    if (least > greatest)
        return axis.isLogarithmic ? PlotScale::logarithmic(1.0, 10.0) : PlotScale::linear(0.0, 1.0);
    if (axis.isLogarithmic)
        return PlotScale::logarithmic(least, greatest);
    if (axis.showsZero)
        return PlotScale::linear(std::min(least, 0.0), std::max(greatest, 0.0));
    return PlotScale::linear(least, greatest);
}

} // namespace

PlotScale xScaleOf(const Plot& plot)
{
    return scaleOf(plot, plot.x, [](const QPointF& point) { return point.x(); });
}

PlotScale yScaleOf(const Plot& plot)
{
    return scaleOf(plot, plot.y, [](const QPointF& point) { return point.y(); });
}

} // namespace carina
