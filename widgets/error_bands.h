#pragma once

#include "engine/core/units.h"

#include <QColor>

namespace carina
{

/// Between which values an error lies.
struct ErrorRange {
    Length least;
    Length most;
};

inline constexpr int kMostErrorBands = 10; ///< more could not be told apart

/// The bands in which an error is drawn, all of one width: the first from `first * width` on.
struct ErrorBands {
    Length width = millimetres(1.0);
    int first = 0;
    int count = 1; ///< at most kMostErrorBands; the last one holds all that is larger, too

    /// Where a band begins, counted from 0; and where the last one ends.
    [[nodiscard]] Length edge(int band) const { return (first + band) * width; }
};

/// The narrowest bands that hold a range, of 1, 2 or 5 times a power of ten and not below 0.1 mm.
/// @pre 0 <= least <= most, both finite
[[nodiscard]] ErrorBands bandsOver(const ErrorRange& range);

/// From pale straw through orange to dark red: of each two bands the one of the larger error is
/// the darker in every channel, by nearly equal steps of lightness (CIELAB), so that the order
/// holds in grey and for colour-blind people, too.
/// @pre 0 <= band < count
[[nodiscard]] QColor bandColor(int band, int count);

/// Of the line where a band begins: that end of the scale which differs most from it.
/// @pre as bandColor
[[nodiscard]] QColor isolineColor(int band, int count);

} // namespace carina
