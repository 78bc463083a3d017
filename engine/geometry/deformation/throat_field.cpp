#include "engine/geometry/deformation/throat_field.h"

#include "engine/geometry/deformation/moved_mesh.h"

namespace carina
{

ThroatField::ThroatField(const Vec3& p_A_carina, const Vec3& p_A_glottis, const Vec3& p_A_incisors)
{
    const Vec3 trachea = p_A_glottis - p_A_carina;
    const double length = (p_A_incisors - p_A_glottis).norm();
    if (!(trachea.norm() > kLeast && length > kLeast))
        return;
    constexpr double kRamp = formula::kStretchTo - formula::kStretchFrom;
    m_frame.up = trachea / (trachea.squaredNorm() * kRamp);
    m_frame.upFrom = -m_frame.up.dot(p_A_carina) - formula::kStretchFrom / kRamp;
    m_frame.incisors = p_A_incisors;
    m_frame.perLength = 1.0 / length;
    m_frame.anchor = p_A_incisors + formula::kAnchor * length * Vec3::UnitY();
}

JawShift<double> jawShift(const RigidTransform& X_AJ)
{
    return {X_AJ.rotation().toRotationMatrix() - Mat3::Identity(), X_AJ.translation()};
}

DisplacementAt<double> throatPull(const FollowingThroat& throat, ThroatTissue tissue,
                                  const Vec3& p_A)
{
    const JawShift<double> jaw = jawShift(throat.X_AJ);
    return pullInHead<double>(headPose(throat.neck), p_A, [&](const Vec3& p_U) {
        return jawPull<double>(throat.field.frame(), tissue, jaw, p_U);
    });
}

ThroatFrame<float> inSingle(const ThroatFrame<double>& frame)
{
    return {frame.up.cast<float>(), static_cast<float>(frame.upFrom), frame.incisors.cast<float>(),
            static_cast<float>(frame.perLength), frame.anchor.cast<float>()};
}

JawShift<float> inSingle(const JawShift<double>& jaw)
{
    return {jaw.turn.cast<float>(), jaw.shift.cast<float>()};
}

TriangleMesh deformed(const TriangleMesh& mesh_A, const FollowingThroat& throat,
                      ThroatTissue tissue)
{
    const JawShift<float> jaw = inSingle(jawShift(throat.X_AJ));
    if (jaw.turn.isZero(0.0F) && jaw.shift.isZero(0.0F))
        return mesh_A;
    const ThroatFrame<float> frame = inSingle(throat.field.frame());
    const auto pullAt = [&](const Vector3<float>& p) {
        return jawPull<float>(frame, tissue, jaw, p);
    };
    if (!throat.neck.isBent())
        return movedMesh(mesh_A, pullAt);
    return movedMesh(mesh_A, [&, head = inSingle(headPose(throat.neck))](const Vector3<float>& p) {
        return pullInHead<float>(head, p, pullAt);
    });
}

} // namespace carina
