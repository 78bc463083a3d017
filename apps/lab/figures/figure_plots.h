#pragma once

#include "apps/lab/figures/figure_tables.h"
#include "widgets/report/plot.h"

namespace carina::lab
{

/// How a figure is drawn: what was measured as marks and its trend as a line; without a trend the
/// line joins the marks.
[[nodiscard]] Plot plotOf(const DriftFigure& figure, const FigureStamp& stamp);

} // namespace carina::lab
