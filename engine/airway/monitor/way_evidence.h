#pragma once

#include "engine/core/units.h"

#include <array>
#include <cstddef>

namespace carina
{

/// Evidence for one of two ways that lead on beside each other, from how a tip lay between them at
/// several depths i: x_i from halfway, the ways being D_i apart. A registration's error is the same
/// at all depths, and the walls let a tip lie anywhere in a lumen. So of the mean m of the x_i, in
/// which each counts by its D_i, as does each in the mean distance D,
///
///     log odds of the other way = D m / (s^2 + b^2 + w^2)
///
/// is the log likelihood ratio of two normal distributions about the ways, s being the
/// registration's error across the ways, b the doubt about the tube's shape, and w that of the
/// mean by the lumens, kInLumen D_i each; all standard deviations. A depth that is seen again
/// counts once: a tube that waits brings no evidence.
struct WayEvidence {
    /// How a tip lies in a lumen, of the distance of both ways; of ours.
    static constexpr double kInLumen = 0.2;
    static constexpr Length kEach = {5e-3};    ///< depths nearer to each other count as one
    static constexpr std::size_t kDepths = 32; ///< what is deeper counts as the deepest

    struct AtDepth {
        double beyond = 0.0; ///< metres from halfway to the other way, smoothed
        double apart = 0.0;
        bool isSeen = false;

        friend bool operator==(const AtDepth&, const AtDepth&) = default;
    };
    std::array<AtDepth, kDepths> depths{};

    void take(Length depth, Length beyond, Length apart);
    /// Of the other way; 0 without evidence.
    [[nodiscard]] double logOdds(Length registration, Length shape) const;

    friend bool operator==(const WayEvidence&, const WayEvidence&) = default;
};

} // namespace carina
