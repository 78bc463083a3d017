#pragma once

#include "engine/geometry/fit/rigid_fit.h"

#include <span>

namespace carina
{

/// One landmark Q, known in the anatomy and touched on the manikin.
struct TouchedLandmark {
    Vec3 p_AQ = Vec3::Zero(); ///< in the anatomy frame A, metres
    Vec3 p_TQ = Vec3::Zero(); ///< in the tracker frame T, metres
};

/// A registration of a patient's anatomy to a manikin.
struct ManikinFit {
    RigidTransform X_TM; ///< pose of the manikin's local frame M, from the touched points
    RigidFit fit;        ///< X_AM, the residuals in the landmarks' order, and the FRE

    /// The pose of the tracker in the anatomy.
    [[nodiscard]] RigidTransform X_AT() const { return fit.X_AM * X_TM.inverse(); }
};

/// Defines the manikin's local frame M by its touched landmarks (siteFrame), and fits the manikin
/// to the anatomy in that frame (fitRigid).
///
/// @param landmarks in the order of their catalogue
/// @returns the errors of siteFrame and fitRigid.
[[nodiscard]] Result<ManikinFit> fitManikin(std::span<const TouchedLandmark> landmarks);

} // namespace carina
