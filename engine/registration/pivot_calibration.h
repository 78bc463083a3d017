#pragma once

#include "engine/core/result.h"
#include "engine/core/units.h"
#include "engine/geometry/rigid_transform.h"

#include <span>

namespace carina
{

/// Where a stylus has its tip, found by turning it about its tip in a divot.
struct PivotCalibration {
    Vec3 p_SQ = Vec3::Zero(); ///< the tip in the stylus frame S, metres
    Vec3 p_TQ = Vec3::Zero(); ///< the divot in the frame T of the poses, metres
    double rms = 0.0;         ///< root mean square distance of the tips from the divot, metres
    int outliers = 0;         ///< poses left out
};

struct PivotSettings {
    Length outlierLimit = millimetres(3.0); ///< a tip further from the divot is left out
    /// RMS turn that every direction of the stylus has to make: the tip is 1 / turn times as
    /// uncertain along the direction that turned least as the tracker.
    Angle leastTurn = degrees(5.0);
};

/// Finds the tip by the algebraic one-step method: the tip p_SQ and the divot p_TQ minimise
///
///     sum_i | X_TS_i * p_SQ - p_TQ |^2
///
/// which is linear in both. While tips lie further than the limit from the divot, a tenth of these
/// is left out, worst first, and the rest solved anew; at last all that agree are solved together.
///
/// @param X_TS poses of the stylus while its tip stood still, in any frame that the divot stood
///             still in.
/// @returns TooFewPoses below ten, or where fewer than ten or half of them agree; NotEnoughMotion
///          where the stylus was turned too little, or about one axis only, so that the tip is
///          undetermined; NotFinite for NaN or infinity; OutOfRange for a kilometre or more.
[[nodiscard]] Result<PivotCalibration> calibratePivot(std::span<const RigidTransform> X_TS,
                                                      const PivotSettings& settings = {});

} // namespace carina
