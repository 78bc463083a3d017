#include "engine/geometry/rigid_transform.h"

#include "engine/geometry/rotation.h"

namespace carina
{

RigidTransform::RigidTransform(const Quat& q, const Vec3& p)
    : m_rotation{canonical(q)}, m_translation{p}
{
}

RigidTransform RigidTransform::translation(const Vec3& p) { return {Quat::Identity(), p}; }

Result<RigidTransform> RigidTransform::fromMatrix(const Mat4& m, double tolerance)
{
    if (!m.allFinite())
        return fail(Errc::NotFinite, "a pose matrix holds a value that is not a number");
    const Mat3 r = m.topLeftCorner<3, 3>();
    const double skew = (r.transpose() * r - Mat3::Identity()).cwiseAbs().maxCoeff();
    const bool lastRowRight =
        (m.row(3) - Eigen::RowVector4d{0.0, 0.0, 0.0, 1.0}).cwiseAbs().maxCoeff() <= tolerance;
    if (skew > tolerance || r.determinant() <= 0.0 || !lastRowRight)
        return fail(Errc::NotARotation, "a pose matrix scales, shears or mirrors");
    return RigidTransform{Quat{r}, m.topRightCorner<3, 1>()};
}

Mat4 RigidTransform::matrix() const
{
    Mat4 m = Mat4::Identity();
    m.topLeftCorner<3, 3>() = m_rotation.toRotationMatrix();
    m.topRightCorner<3, 1>() = m_translation;
    return m;
}

RigidTransform RigidTransform::inverse() const
{
    const Quat back = m_rotation.conjugate();
    return {back, -(back * m_translation)};
}

RigidTransform interpolate(const RigidTransform& X_F0, const RigidTransform& X_F1, double s)
{
    const Vec3 turn_0 = rotationVector(X_F0.rotation().conjugate() * X_F1.rotation());
    return {X_F0.rotation() * rotationFromVector(s * turn_0),
            X_F0.translation() + s * (X_F1.translation() - X_F0.translation())};
}

} // namespace carina
