#pragma once

#include "engine/core/units.h"
#include "engine/geometry/vec.h"

namespace carina
{

/// A touch of a tool's tip with the stylus, compared with where its calibration has it.
struct TipCheck {
    Length error; ///< distance of the touch from the calibrated tip
    Length bound; ///< 95 % of such distances stay below this while the tool is as it was

    /// Whether the tool was bent, or its markers moved on it.
    [[nodiscard]] bool isBent() const { return error > bound; }
};

/// Bounds below this are taken for this one: a hand finds the middle of an opening no better.
inline constexpr Length kLeastTipBound = millimetres(1.0);

/// @param p_NQ_tip     the tip in the frame N of the tool's markers, by its calibration, metres
/// @param covariance_N of that
/// @param fle          RMS error of a touch, as the calibration estimated it
/// @param degrees      degrees of freedom of that estimate, above 0
/// @param p_NQ         the touch
[[nodiscard]] TipCheck checkTip(const Vec3& p_NQ_tip, const Mat3& covariance_N, Length fle,
                                double degrees, const Vec3& p_NQ);

} // namespace carina
