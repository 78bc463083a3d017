#pragma once

#include "engine/core/units.h"
#include "engine/geometry/fit/rigid_fit.h"

#include <cstdint>

namespace carina
{

/// The explanation found for a set of touches.
enum class TouchOrder : std::uint8_t {
    AsGiven,     ///< each touch belongs to its landmark
    Exchanged,   ///< landmarks were touched in another order, such as left for right
    MirrorImage, ///< no order fits, but the mirror image: a file has an axis inverted
    Unexplained  ///< none: a landmark touched at a wrong place, or another patient
};

/// The result of recogniseOrder.
struct OrderFinding {
    TouchOrder order = TouchOrder::Unexplained;
    /// Per landmark the index of the pair whose touch belongs to it: the correct order where
    /// `order` is Exchanged, otherwise 0, 1, 2 ...
    std::vector<std::size_t> touchOf;
    Length rmsAsGiven; ///< FRE; infinite where the pairs as given cannot be fitted
    Length rms;        ///< FRE of the order (or mirror image) found
    /// Number of orders that explain the touches. If more than one, the landmarks are too symmetric
    /// to distinguish, for example, left from right.
    std::size_t explanations = 0;

    /// The pairs with each landmark's own touch.
    [[nodiscard]] std::vector<LandmarkPair> repaired(std::span<const LandmarkPair> pairs) const;
};

/// The largest number of (partial) orders that are examined.
inline constexpr std::size_t kMostOrders = 100'000;

/// Recognises landmarks that were touched in another order, and mirrored coordinates. An order
/// explains the touches where the sum of its squared residuals is below the kPlausibleShare
/// quantile of chi-squared with 3 N - 6 degrees of freedom, scaled by the FLE. The given order is
/// kept where it explains them; otherwise the order with the smallest residuals is taken, if it
/// does.
///
/// Orders are built landmark by landmark (backtracking) and abandoned as soon as the distance of
/// two touches differs from that of their landmarks by more than kFarthestDeviations.
///
/// @param fle the fiducial localisation error, RMS, above 0
/// @returns TooFewLandmarks; NotFinite and OutOfRange as fitRigid; DegenerateLandmarks where more
///          than kMostOrders would have to be examined.
[[nodiscard]] Result<OrderFinding> recogniseOrder(std::span<const LandmarkPair> pairs, Length fle);

} // namespace carina
