#include "engine/geometry/deformation/chest_field.h"

#include "engine/core/expects.h"
#include "engine/geometry/deformation/moved_vertex.h"

#include <algorithm>

namespace carina
{
namespace
{

Shares<double> along(const Vec3& v) { return {v.x(), v.y(), v.z()}; }
Shares<float> along(const Vec3f& v) { return {v.x(), v.y(), v.z()}; }
Vec3 vector(const Shares<double>& s) { return {s.u, s.v, s.h}; }
Vec3f vector(const Shares<float>& s) { return {s.u, s.v, s.h}; }

float rounded(double x) { return static_cast<float>(x); }

Shares<float> rounded(const Shares<double>& s)
{
    return {rounded(s.u), rounded(s.v), rounded(s.h)};
}

ChestTerms<float> rounded(const ChestTerms<double>& c)
{
    return {rounded(c.descent),  rounded(c.forward),  rounded(c.flare),  rounded(c.lift),
            rounded(c.bulkBack), rounded(c.bulkDown), rounded(c.shrink), rounded(c.shift)};
}

} // namespace

ChestField::ChestField(const Box& lungs_A, const Vec3& p_A_right, const Vec3& p_A_left,
                       double frontShare)
{
    const Vec3 size = lungs_A.size();
    CARINA_EXPECTS((size.array() > 0.0).all());
    m_frame.origin = {lungs_A.centre().x(), lungs_A.min.y(), lungs_A.max.z()};
    m_frame.perMetre = {2.0 / size.x(), 1.0 / size.y(), -1.0 / size.z()};
    m_frame.frontShare = frontShare;
    m_frame.rightHilum = along(shares(p_A_right));
    m_frame.leftHilum = along(shares(p_A_left));
    m_frame.rightHilum.u = std::min(m_frame.rightHilum.u, -kLeastHilum);
    m_frame.leftHilum.u = std::max(m_frame.leftHilum.u, kLeastHilum);
}

Box ChestField::unitChest()
{
    Box box_A;
    box_A.include(Vec3{-1.0, -1.0, -1.0});
    box_A.include(Vec3{1.0, 1.0, 1.0});
    return box_A;
}

Vec3 ChestField::shares(const Vec3& p_A) const
{
    return (p_A - vector(m_frame.origin)).cwiseProduct(vector(m_frame.perMetre));
}

FieldDisplacement ChestField::at(const Vec3& p_A, const ChestMotion& motion) const
{
    const ChestValue<double> there = chestValue(m_frame, motion, along(shares(p_A)));
    const Vec3 perMetre = vector(m_frame.perMetre);
    Mat3 slopes;
    slopes << vector(there.slope_u).transpose(), vector(there.slope_v).transpose(),
        vector(there.slope_h).transpose();
    return {vector(there.f).cwiseQuotient(perMetre),
            perMetre.cwiseInverse().asDiagonal() * slopes * perMetre.asDiagonal()};
}

ChestFrame<float> inSingle(const ChestFrame<double>& frame)
{
    return {rounded(frame.origin), rounded(frame.perMetre), rounded(frame.rightHilum),
            rounded(frame.leftHilum), rounded(frame.frontShare)};
}

ChestCoefficients<float> inSingle(const ChestMotion& motion)
{
    return {rounded(motion.right), rounded(motion.left)};
}

TriangleMesh deformed(const TriangleMesh& mesh_A, const ChestField& field,
                      const ChestMotion& motion)
{
    CARINA_EXPECTS(mesh_A.normals.size() == mesh_A.positions.size());
    const ChestFrame<float> frame = inSingle(field.frame());
    const ChestCoefficients<float> terms = inSingle(motion);
    const Shares<float> metrePer{1.0F / frame.perMetre.u, 1.0F / frame.perMetre.v,
                                 1.0F / frame.perMetre.h};
    TriangleMesh out;
    out.triangles = mesh_A.triangles;
    out.positions.reserve(mesh_A.positions.size());
    out.normals.reserve(mesh_A.positions.size());
    for (std::size_t i = 0; i < mesh_A.positions.size(); ++i) {
        const MovedVertex<float> moved = movedVertex(
            frame, terms, metrePer, along(mesh_A.positions[i]), along(mesh_A.normals[i]));
        out.positions.push_back(vector(moved.position));
        out.normals.push_back(vector(moved.normal));
    }
    return out;
}

} // namespace carina
