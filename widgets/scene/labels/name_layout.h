#pragma once

#include <QPointF>
#include <QRect>
#include <QSize>

#include <cstddef>
#include <span>
#include <vector>

namespace carina
{

/// A name to be written beside a point of a picture. Pixels, right and down from the upper left
/// corner.
struct NameWish {
    QPointF anchor;
    double depth = 0.0; ///< of the anchor along the line of sight, metres
    QSize size;         ///< of the written name
    QRect before{};     ///< where it was written last; null: nowhere
};

/// Where a name is written, and where its leader line ends.
struct PlacedName {
    std::size_t wish = 0; ///< index of the wish
    QRect box;
    QPointF anchor;
    QPointF leaderEnd; ///< the point of the box nearest to the anchor
};

/// Lays out names beside their anchors, the nearest to the eye first: each at the first free place
/// of a fixed sequence of distances and directions around its anchor. A place is free if the name
/// lies inside the picture, covers no other name, no anchor and no rectangle of `taken`, and if no
/// leader line crosses a name or another leader line. A name without a free place is left out. One
/// that was written before stays where it is while that place is free and neither too near to its
/// anchor nor too far from it, so that a name can be read while what it names moves.
///
/// @returns the names that have a place, nearest first
[[nodiscard]] std::vector<PlacedName> layOutNames(std::span<const NameWish> wishes,
                                                  const QSize& picture,
                                                  std::span<const QRect> taken = {});

} // namespace carina
