#pragma once

#include "engine/registration/fit/rigid_fit.h"

#include <span>

namespace carina
{

/// One landmark Q, known in the anatomy and touched on the manikin.
struct TouchedLandmark {
    Vec3 p_AQ = Vec3::Zero(); ///< in the anatomy frame A, metres
    Vec3 p_TQ = Vec3::Zero(); ///< in the tracker frame T, metres
};

/// A patient's anatomy laid on a manikin.
struct ManikinFit {
    RigidTransform X_TM; ///< the manikin's local frame, from the touched points
    RigidFit fit;        ///< X_AM, residuals in the landmarks' order, FRE

    [[nodiscard]] RigidTransform X_AT() const { return fit.X_AM * X_TM.inverse(); }
};

/// Makes the manikin's local frame of its touched landmarks (siteFrame) and fits the manikin onto
/// the anatomy in it (fitRigid).
///
/// @param landmarks in the order of their catalogue
/// @returns what siteFrame and fitRigid return.
[[nodiscard]] Result<ManikinFit> fitManikin(std::span<const TouchedLandmark> landmarks);

} // namespace carina
