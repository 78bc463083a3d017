#pragma once

#include "engine/core/units.h"
#include "engine/registration/fit/rigid_fit.h"

#include <cstdint>

namespace carina
{

/// What explains a set of touches.
enum class TouchOrder : std::uint8_t {
    AsGiven,     ///< each touch belongs to its landmark
    Exchanged,   ///< landmarks were touched in another order, as left for right
    MirrorImage, ///< no order fits, but the mirror image does: an axis of a file points backwards
    Unexplained  ///< neither: a landmark touched at a wrong place, or another patient
};

struct OrderFinding {
    TouchOrder order = TouchOrder::Unexplained;
    /// The touch, by its place among the pairs, that belongs to each landmark: the repair where
    /// order is Exchanged, otherwise 0, 1, 2 ...
    std::vector<std::size_t> touchOf;
    Length rmsAsGiven; ///< FRE; infinite where the pairs as given cannot be fitted
    Length rms;        ///< of the order found
    /// How many orders explain the touches. More than one: these landmarks cannot tell, and left
    /// may be right.
    std::size_t explanations = 0;

    /// The pairs with each landmark's own touch.
    [[nodiscard]] std::vector<LandmarkPair> repaired(std::span<const LandmarkPair> pairs) const;
};

/// The most orders that are looked at: beyond it landmarks are too many or too close together.
inline constexpr std::size_t kMostOrders = 100'000;

/// Recognises landmarks that were touched in another order, and mirrored coordinates. An order
/// explains the touches where the sum of its squared residuals is what errors of this size leave in
/// all but one of a thousand fits (chi-squared with 3 N - 6 degrees of freedom). The order as given
/// is kept where it explains them; otherwise the one that leaves least.
///
/// Orders are built landmark by landmark and given up as soon as two touches are not as far from
/// each other as their landmarks.
///
/// @param fle root of the expected squared length of an error, above 0
/// @returns TooFewLandmarks; NotFinite and OutOfRange as fitRigid; DegenerateLandmarks where more
///          than kMostOrders would have to be looked at.
[[nodiscard]] Result<OrderFinding> recogniseOrder(std::span<const LandmarkPair> pairs, Length fle);

} // namespace carina
