#pragma once

#include "engine/tracking/pose_sample.h"

#include <algorithm>
#include <cmath>

namespace carina
{

/// A sample expressed in another frame G, in which F does not move: X_GO = X_GF * X_FO, with the
/// motion in axes of G. Time, validity, error, covariance, markers and `how` are unchanged.
[[nodiscard]] inline PoseSample reframed(const RigidTransform& X_GF, PoseSample sample)
{
    sample.X_FO = X_GF * sample.X_FO;
    if (sample.motion) {
        sample.motion->v_FO = X_GF.rotation() * sample.motion->v_FO;
        sample.motion->w_FO = X_GF.rotation() * sample.motion->w_FO;
        sample.motion->a_FO = X_GF.rotation() * sample.motion->a_FO;
        sample.motion->alpha_FO = X_GF.rotation() * sample.motion->alpha_FO;
    }
    return sample;
}

/// The sample of a frame P that is fixed to the object O: X_FP = X_FO * X_OP, with the velocity of
/// P's origin, v_FP = v_FO + w_FO x (R_FO p_OP), and its acceleration.
[[nodiscard]] inline PoseSample attached(PoseSample sample, const RigidTransform& X_OP)
{
    const Vec3 arm_F = sample.X_FO.rotation() * X_OP.translation();
    const double perAxis = 2.0 / 3.0 * arm_F.squaredNorm(); // of the shift by a turn, in the mean
    if (sample.motion) {
        Motion& motion = *sample.motion;
        const Vec3 swing_F = motion.w_FO.cross(arm_F);
        motion.v_FO += swing_F;
        motion.a_FO += motion.alpha_FO.cross(arm_F) + motion.w_FO.cross(swing_F);
        if (motion.growth)
            for (std::size_t k = 0; k < motion.growth->position.size(); ++k)
                motion.growth->position[k] += perAxis * motion.growth->rotation[k];
    }
    if (sample.deviation)
        sample.deviation->position = metres(std::hypot(
            sample.deviation->position.si, std::sqrt(perAxis) * sample.deviation->rotation.si));
    sample.covariance_O.reset(); // it is not that of P
    sample.markers.reset();
    sample.X_FO = sample.X_FO * X_OP;
    return sample;
}

/// The pose of an object O in the frame of another object J, both measured in F at the same time:
/// X_JO = X_FJ^-1 * X_FO, with the velocity of O relative to J,
///
///     v_JO = R_JF (v_FO - v_FJ - w_FJ x (p_FO - p_FJ))        w_JO = R_JF (w_FO - w_FJ)
///
/// where both have a motion, and none otherwise; and with its acceleration. Validity and `how` are
/// those of the worse of the two; the error is the root of the sum of both squared errors.
[[nodiscard]] inline PoseSample seenFrom(const PoseSample& X_FJ, PoseSample X_FO)
{
    const RigidTransform X_JF = X_FJ.X_FO.inverse();
    X_FO.covariance_O.reset(); // it is not that of both
    X_FO.markers.reset();
    if (X_FO.motion && X_FJ.motion) {
        const Vec3 arm_F = X_FO.X_FO.translation() - X_FJ.X_FO.translation();
        const Motion& of_J = *X_FJ.motion;
        Motion& of_O = *X_FO.motion;
        of_O.v_FO -= of_J.v_FO + of_J.w_FO.cross(arm_F);
        of_O.w_FO -= of_J.w_FO;
        of_O.a_FO -= of_J.a_FO + of_J.alpha_FO.cross(arm_F) + 2.0 * of_J.w_FO.cross(of_O.v_FO)
                     + of_J.w_FO.cross(of_J.w_FO.cross(arm_F));
        of_O.alpha_FO -= of_J.alpha_FO + of_J.w_FO.cross(of_O.w_FO);
        of_O.growth.reset();
    } else {
        X_FO.motion.reset();
    }
    X_FO.validity = std::max(X_FO.validity, X_FJ.validity);
    X_FO.how = std::max(X_FO.how, X_FJ.how);
    X_FO.error = std::hypot(X_FO.error, X_FJ.error);
    if (X_FO.deviation && X_FJ.deviation) {
        const double swing =
            std::sqrt(2.0 / 3.0) * (X_FO.X_FO.translation() - X_FJ.X_FO.translation()).norm();
        X_FO.deviation = PoseDeviation{
            metres(std::hypot(X_FO.deviation->position.si, X_FJ.deviation->position.si,
                              swing * X_FJ.deviation->rotation.si)),
            radians(std::hypot(X_FO.deviation->rotation.si, X_FJ.deviation->rotation.si))};
    } else {
        X_FO.deviation.reset();
    }
    return reframed(X_JF, X_FO);
}

} // namespace carina
