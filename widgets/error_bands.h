#pragma once

#include "engine/core/units.h"

#include <QColor>

namespace carina
{

/// The range of an error.
struct ErrorRange {
    Length least;
    Length most;
};

inline constexpr int kMostErrorBands = 10; ///< more could not be distinguished

/// The colour bands of an error map, all of one width; the first begins at `first * width`.
struct ErrorBands {
    Length width = millimetres(1.0);
    int first = 0;
    int count = 1; ///< at most kMostErrorBands; larger errors belong to the last one

    /// The lower edge of a band, counted from 0; edge(count) is the upper edge of the last one.
    [[nodiscard]] Length edge(int band) const { return (first + band) * width; }
};

/// The narrowest bands that cover a range; their width is 1, 2 or 5 times a power of ten in
/// millimetres, at least 0.1 mm.
/// @pre 0 <= least <= most, both finite
[[nodiscard]] ErrorBands bandsOver(const ErrorRange& range);

/// From pale straw through orange to dark red. A larger error is darker in every channel, in nearly
/// equal steps of lightness (CIELAB), so that the order is visible in grey and for colour-blind
/// people, too.
/// @pre 0 <= band < count
[[nodiscard]] QColor bandColor(int band, int count);

/// The colour of the line at the lower edge of a band: the end of the scale with more contrast.
/// @pre as bandColor
[[nodiscard]] QColor isolineColor(int band, int count);

} // namespace carina
