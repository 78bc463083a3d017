#pragma once

#include "widgets/report/plot_scale.h"

#include <QPointF>
#include <QString>

#include <vector>

namespace carina
{

/// The settings of one axis; its scale follows from the data.
struct PlotAxis {
    QString label{}; ///< with its unit
    bool isLogarithmic = false;
    bool showsZero = false; ///< a linear axis includes 0 for any data
};

/// One data series: marks, a line, or both. Points that an axis cannot show are left out.
struct PlotSeries {
    QString name{}; ///< in the legend
    std::vector<QPointF> marks{};
    std::vector<QPointF> line{};
    bool isReference = false; ///< drawn thick and solid, as a bound for comparison
};

/// A figure on white, to be printed: series differ by mark and dash as well as by colour, text is
/// of 12 points or more, and the legend is above the axes, where it covers nothing.
struct Plot {
    QString title{};
    QString stamp{}; ///< below the figure: how it was made
    PlotAxis x{};
    PlotAxis y{};
    std::vector<PlotSeries> series{};
};

/// The scale that covers all the data of an axis; 0 to 1, or 1 to 10 if logarithmic, without data.
[[nodiscard]] PlotScale xScaleOf(const Plot& plot);
[[nodiscard]] PlotScale yScaleOf(const Plot& plot);

} // namespace carina
