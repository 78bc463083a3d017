#pragma once

#include "engine/geometry/fit/rigid_fit.h"

namespace carina
{

/// The size of the manikin relative to the anatomy, as its touched landmarks show it.
struct ManikinScale {
    double scale = 1.0;     ///< above 1 for a manikin that is larger than the anatomy
    double deviation = 0.0; ///< standard error of scale, estimated from the residuals
    double degrees = 0.0;   ///< degrees of freedom of that estimate: 3 N - 7

    /// Whether scale differs from 1 by more than kNoticedScale, and by more than chance explains:
    /// |scale - 1| / deviation is above the quantile of Student's t that an anatomy of the
    /// manikin's size exceeds with probability kScaleFalseAlarm.
    [[nodiscard]] bool isOff() const;
};

/// A difference in size below this share is not reported: it moves a place 100 mm from the
/// landmarks' centre by 1 mm.
inline constexpr double kNoticedScale = 0.01;

/// Probability that a manikin of the right size is called larger or smaller.
inline constexpr double kScaleFalseAlarm = 0.01;

/// The least-squares similarity from the anatomy to the manikin: the scale k, rotation R and shift
/// t that minimise
///
///     sum_i | p_MQ_i - (k R p_AQ_i + t) |^2
///
/// With the distances d from the means and the rotation of fitRigid, which is that of the
/// similarity (Horn 1987; Umeyama 1991), k = sum d_M . R d_A / sum |d_A|^2. To first order scale,
/// rotation and shift do not influence each other, so that for equal isotropic errors of the
/// touches, with s^2 the squares that remain over their 3 N - 7 degrees of freedom, the standard
/// error of k is s / sqrt(sum |d_A|^2).
///
/// @returns TooFewLandmarks below four pairs; the errors of fitRigid.
[[nodiscard]] Result<ManikinScale> manikinScale(std::span<const LandmarkPair> pairs);

/// The pairs with the anatomy's points taken away from their mean by this factor.
[[nodiscard]] std::vector<LandmarkPair> withAnatomyScaled(std::span<const LandmarkPair> pairs,
                                                          double scale);

} // namespace carina
