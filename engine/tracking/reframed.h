#pragma once

#include "engine/tracking/pose_sample.h"

namespace carina
{

/// A sample told in another frame G, in which F stands still: X_GO = X_GF * X_FO, and the motion
/// turned into axes of G. When, how and how well it was measured stay as they are.
[[nodiscard]] inline PoseSample reframed(const RigidTransform& X_GF, PoseSample sample)
{
    sample.X_FO = X_GF * sample.X_FO;
    if (sample.motion) {
        sample.motion->v_FO = X_GF.rotation() * sample.motion->v_FO;
        sample.motion->w_FO = X_GF.rotation() * sample.motion->w_FO;
    }
    return sample;
}

/// The sample of a frame P that is fixed to the object O: X_FP = X_FO * X_OP, with the velocity of
/// P's origin, v_FP = v_FO + w_FO x (R_FO p_OP).
[[nodiscard]] inline PoseSample attached(PoseSample sample, const RigidTransform& X_OP)
{
    if (sample.motion) {
        const Vec3 arm_F = sample.X_FO.rotation() * X_OP.translation();
        sample.motion->v_FO += sample.motion->w_FO.cross(arm_F);
    }
    sample.X_FO = sample.X_FO * X_OP;
    return sample;
}

} // namespace carina
