#pragma once

#include "engine/core/result.h"
#include "engine/geometry/vec.h"

namespace carina
{

/// The pose of one frame in another: a proper rotation and a translation, nothing else (no scale,
/// no mirror).
///
/// Named with two frame letters: X_TM is the pose of M in T and takes points given in M to T,
/// p_TQ = X_TM * p_MQ. Adjacent letters cancel: X_AE = X_AM * X_MT * X_TE. Metres.
class RigidTransform
{
public:
    /// The identity: both frames coincide.
    RigidTransform() = default;

    /// @pre q is finite and not zero; it is brought to unit length with w >= 0.
    RigidTransform(const Quat& q, const Vec3& p);

    [[nodiscard]] static RigidTransform translation(const Vec3& p);

    /// From a homogeneous matrix, as trackers and files give it.
    ///
    /// @returns NotFinite for NaN or inf; NotARotation when the upper left 3x3 block R is not
    ///          orthonormal (a coefficient of R^T R - 1 above `tolerance`) or mirrors, or when the
    ///          last row is not 0 0 0 1.
    [[nodiscard]] static Result<RigidTransform> fromMatrix(const Mat4& m, double tolerance = 1e-3);

    [[nodiscard]] const Quat& rotation() const { return m_rotation; }
    [[nodiscard]] const Vec3& translation() const { return m_translation; }
    [[nodiscard]] Mat4 matrix() const;
    [[nodiscard]] RigidTransform inverse() const;

    friend RigidTransform operator*(const RigidTransform& X_AB, const RigidTransform& X_BC)
    {
        return {X_AB.m_rotation * X_BC.m_rotation, X_AB * X_BC.m_translation};
    }
    friend Vec3 operator*(const RigidTransform& X_AB, const Vec3& p_BQ)
    {
        return X_AB.m_rotation * p_BQ + X_AB.m_translation;
    }

private:
    Quat m_rotation = Quat::Identity();
    Vec3 m_translation = Vec3::Zero();
};

/// The pose a share s of the way from X_F0 (s = 0) to X_F1 (s = 1): linear for the origin, shortest
/// great circle (slerp) for the rotation. s outside 0..1 extrapolates both.
[[nodiscard]] RigidTransform interpolate(const RigidTransform& X_F0, const RigidTransform& X_F1,
                                         double s);

} // namespace carina
