#pragma once

#include "apps/lab/figures/paper_values.h"

#include <QByteArray>

#include <span>

namespace carina::lab
{

/// What every table and every figure says of its making.
struct FigureStamp {
    QByteArray version; ///< of Carina
    std::uint32_t seed = 0;
    int seeds = 0;
};

/// The points of a figure: columns version, seed, seeds, network, curve, those of its axes, and
/// trend, which is empty where there is none.
[[nodiscard]] QByteArray pointsCsv(const DriftFigure& figure, const FigureStamp& stamp);

/// The trends of all figures: columns version, seed, seeds, network, figure, curve, x, y, order,
/// coefficient_0 to coefficient_6, empty above the order, and psi_1 to psi_5, the numbers measured
/// with 2 to 6 participants where a figure is of these. coefficient_1 of order 1 is the slope.
[[nodiscard]] QByteArray trendsCsv(std::span<const DriftFigure> figures, const FigureStamp& stamp);

/// What the 2004 paper prints, beside ours: columns version, seed, seeds, network, figure, y,
/// quantity, measured, order (of our trend), paper_figure, paper_printed, paper_trend, source.
[[nodiscard]] QByteArray paperCsv(std::span<const PaperValue> values, const FigureStamp& stamp);

} // namespace carina::lab
