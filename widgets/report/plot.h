#pragma once

#include "widgets/report/plot_scale.h"

#include <QPointF>
#include <QString>

#include <vector>

namespace carina
{

/// One axis as it is asked for; its scale follows from the numbers.
struct PlotAxis {
    QString label{}; ///< with its unit
    bool isLogarithmic = false;
    bool showsZero = false; ///< of a linear axis, wherever the numbers are
};

/// One thing that a plot shows: marks, a line, or both. What an axis cannot show is left out.
struct PlotSeries {
    QString name{}; ///< in the legend
    std::vector<QPointF> marks{};
    std::vector<QPointF> line{};
    bool isReference = false; ///< drawn thick and plain, as a bound that others are held against
};

/// A figure on white, to be printed: series differ by mark and dash as well as by colour, words are
/// of 12 points or more, and the legend lies above the axes, where it covers nothing.
struct Plot {
    QString title{};
    QString stamp{}; ///< below: what made it
    PlotAxis x{};
    PlotAxis y{};
    std::vector<PlotSeries> series{};
};

/// The scale that holds all the numbers of an axis; 0 to 1, or 1 to 10, where there are none.
[[nodiscard]] PlotScale xScaleOf(const Plot& plot);
[[nodiscard]] PlotScale yScaleOf(const Plot& plot);

} // namespace carina
