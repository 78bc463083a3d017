#pragma once

#include "engine/core/units.h"

#include <array>
#include <cstddef>

namespace carina
{

/// Evidence for one of two ways that lead on beside each other, from how a tip lay between them at
/// several depths i: x_i from halfway, the ways being D_i apart. The walls let a tip lie anywhere
/// in a lumen, l_i = kInLumen D_i. A registration's error s is the same at all depths. So is the
/// cause for which a tube bends otherwise than it is taken to; how far that moves its tip is not,
/// b_i: as far as is said of that depth, and no less than the mean of the depths up to there,
/// weighted by the D_i, as shapes may happen to agree where a tip passes. Each depth counts by
///
///     g_i = D_i (s^2 + l_i^2) / (s^2 + l_i^2 + b_i^2),
///
/// which is D_i of a tube that does not bend. With m, D and b for the means of x_i, D_i and b_i by
/// these, and w^2 = sum (g_i l_i)^2 / (sum g_i)^2,
///
///     log odds of the other way = D m / (s^2 + b^2 + w^2)
///
/// is the log likelihood ratio of two normal distributions about the ways; s, l_i and b_i are
/// standard deviations. A depth that is seen again counts once: a tube that waits brings no
/// evidence.
struct WayEvidence {
    /// How a tip lies in a lumen, of the distance of both ways; of ours.
    static constexpr double kInLumen = 0.2;
    static constexpr Length kEach = {5e-3};    ///< depths nearer to each other count as one
    static constexpr std::size_t kDepths = 32; ///< what is deeper counts as the deepest

    struct AtDepth {
        double beyond = 0.0; ///< metres from halfway to the other way, smoothed
        double apart = 0.0;
        double shape = 0.0; ///< doubt about `beyond` by the tube's shape, likewise
        bool isSeen = false;

        friend bool operator==(const AtDepth&, const AtDepth&) = default;
    };
    std::array<AtDepth, kDepths> depths{};

    /// @param shape the doubt about the tip's place by the tube's shape, a standard deviation
    void take(Length depth, Length beyond, Length apart, Length shape);
    /// Of the other way; 0 without evidence.
    [[nodiscard]] double logOdds(Length registration) const;
    /// Whether bending leaves more doubt, b, than the registration.
    [[nodiscard]] bool isBent(Length registration) const;

    friend bool operator==(const WayEvidence&, const WayEvidence&) = default;
};

} // namespace carina
