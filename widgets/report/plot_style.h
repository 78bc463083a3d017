#pragma once

#include "widgets/report/plot.h"
#include "widgets/report/svg_writer.h"

namespace carina
{

/// The stroke of a series' line: colours that colour-blind people can distinguish, and dashes for
/// print in grey.
[[nodiscard]] SvgStroke lineStroke(const Plot& plot, std::size_t series);

/// The fill of a series' marks: its colour for the first five series, white for the next five.
[[nodiscard]] QString markFill(const Plot& plot, std::size_t series);

/// The outline of a series' mark, one of five shapes, at a position in pixels, as SVG path data.
[[nodiscard]] QString markOutline(std::size_t series, const QPointF& at);

} // namespace carina
