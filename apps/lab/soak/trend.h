#pragma once

#include <span>
#include <vector>

namespace carina::lab
{

/// A figure at a time.
struct TimedFigure {
    double time = 0.0;
    double figure = 0.0;
};

/// The straight line through figures, by least squares.
struct Trend {
    double slope = 0.0; ///< per unit of time
    /// Of the slope. Figures close in time are alike, so they count as n (1 - r) / (1 + r) of them,
    /// with r the correlation of one deviation from the line with the next (Santer et al. 2000).
    double standardError = 0.0;
};

/// The least figure of each of so many equal parts of the time, from the first to the last.
/// @pre parts > 0; the times rise.
[[nodiscard]] std::vector<TimedFigure> leastOfEach(std::span<const TimedFigure> figures, int parts);

/// @pre at least three figures, whose times rise.
[[nodiscard]] Trend trendOf(std::span<const TimedFigure> figures);

} // namespace carina::lab
