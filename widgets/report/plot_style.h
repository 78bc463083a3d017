#pragma once

#include "widgets/report/plot.h"
#include "widgets/report/svg_writer.h"

namespace carina
{

/// How a series' line is drawn: colours that the colour-blind tell apart, and dashes for print in
/// grey.
[[nodiscard]] SvgStroke lineStroke(const Plot& plot, std::size_t series);

/// What fills a series' marks: its colour for the first five series, white for the next five.
[[nodiscard]] QString markFill(const Plot& plot, std::size_t series);

/// The outline of a series' mark at a place of the page, one of five, as SVG path data.
[[nodiscard]] QString markOutline(std::size_t series, const QPointF& at);

} // namespace carina
