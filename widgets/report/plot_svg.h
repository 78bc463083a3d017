#pragma once

#include "widgets/report/plot.h"

#include <QByteArray>

namespace carina
{

/// A pixel of a figure is 1/96 inch.
inline constexpr int kFigureWidth = 960;
inline constexpr int kFigureHeight = 600;
inline constexpr int kFigurePixelsPerInch = 96;

/// A plot as an SVG file: each series' line is one polyline, its marks one path. The plot's title
/// and stamp are also the SVG title and description. The same plot gives the same bytes,
/// independent of installed fonts.
[[nodiscard]] QByteArray svgOf(const Plot& plot);

} // namespace carina
