#include "engine/geometry/deformation/neck_field.h"

#include "engine/geometry/deformation/moved_mesh.h"
#include "engine/geometry/rotation.h"

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

// All in shares of the way from incisors to glottis, in the sagittal plane.

/// Between the sixth and seventh cervical vertebra, from the glottis; and the joints of the head,
/// from the edge of the incisors.
const Vec3 kNeckHinge{0.0, 0.25, -0.30};
const Vec3 kHeadHinge{0.0, 1.23, 0.31};

/// The lean of the neck, and heights along it from the glottis: where the trunk ends, at the level
/// of the sternal notch and the first thoracic vertebra, and where the head begins.
constexpr Angle kLean = degrees(20.0);
constexpr double kTrunkEnds = -0.84;
constexpr double kHeadBegins = 0.08;

/// The level surfaces of extension fall by kFallInFront to the front and by kFallBehind to the
/// back, within kRidge of the hinge less; and where it begins and ends, from the level of the
/// hinge.
constexpr double kFallInFront = 1.1;
constexpr double kFallBehind = 0.4;
constexpr double kRidge = 0.17;
constexpr double kTurnsFrom = -0.525;
constexpr double kTurnsWholly = 0.33;

/// From this flexion on a head is extended no more than in the sniffing position.
constexpr Angle kFlexed = degrees(20.0);

Vec3 inMidplane(Vec3 p, double x)
{
    p.x() = x;
    return p;
}

NeckBend<double> flexionOf(const Vec3& p_A_glottis, double length, Angle flexion)
{
    const double ramp = (kHeadBegins - kTrunkEnds) * length;
    NeckBend<double> bend;
    bend.hinge = p_A_glottis + length * kNeckHinge;
    bend.angle = flexion.si;
    bend.along = Vec3{0.0, -std::sin(kLean.si), std::cos(kLean.si)} / ramp;
    bend.from = -bend.along.dot(p_A_glottis) - kTrunkEnds * length / ramp;
    return bend;
}

NeckBend<double> extensionOf(const Vec3& p_A_incisors, double length, Angle extension)
{
    const double ramp = (kTurnsWholly - kTurnsFrom) * length;
    NeckBend<double> bend;
    bend.hinge = p_A_incisors + length * kHeadHinge;
    bend.angle = 0.0 - extension.si;
    bend.along = Vec3{0.0, -0.5 * (kFallInFront - kFallBehind), 1.0} / ramp;
    bend.from = -bend.along.dot(bend.hinge) - kTurnsFrom * length / ramp;
    bend.arch = 0.5 * (kFallInFront + kFallBehind) / ramp;
    bend.soft2 = kRidge * length * kRidge * length;
    return bend;
}

RigidTransform aboutHinge(const NeckBend<double>& bend)
{
    return RigidTransform::translation(bend.hinge)
           * RigidTransform{rotationFromVector(bend.angle * Vec3::UnitX()), Vec3::Zero()}
           * RigidTransform::translation(-bend.hinge);
}

NeckBend<float> bendInSingle(const NeckBend<double>& bend)
{
    return {bend.hinge.cast<float>(),      static_cast<float>(bend.angle),
            bend.along.cast<float>(),      static_cast<float>(bend.from),
            static_cast<float>(bend.arch), static_cast<float>(bend.soft2)};
}

} // namespace

HeadPosition withinReach(const HeadPosition& position)
{
    const double flexion = std::clamp(position.flexion.si, kLeastFlexion.si, kMostFlexion.si);
    const double share = std::clamp(flexion / kFlexed.si, 0.0, 1.0);
    const double most = std::lerp(kMostExtension.si, kSniffing.extension.si, share);
    return {radians(flexion), radians(std::clamp(position.extension.si, kLeastExtension.si, most))};
}

HeadPosition withinReach(const HeadPosition& position, Length way)
{
    const double share = std::min(way / kGrownWay, 1.0);
    const Angle most = share * kMostFlexion;
    return withinReach({std::min(position.flexion, most), position.extension});
}

NeckField::NeckField(const Vec3& p_A_glottis, const Vec3& p_A_incisors,
                     const HeadPosition& position)
{
    const double length = (p_A_incisors - p_A_glottis).norm();
    const HeadPosition drawn = withinReach(position, metres(length));
    if (!(length > kLeast) || drawn == HeadPosition{})
        return;
    m_frame.flexion = flexionOf(p_A_glottis, length, drawn.flexion);
    m_frame.extension =
        extensionOf(inMidplane(p_A_incisors, p_A_glottis.x()), length, drawn.extension);
    m_X_AU = aboutHinge(m_frame.flexion) * aboutHinge(m_frame.extension);
}

Angle NeckField::turnAt(const Vec3& p_A) const
{
    const Vec3 extended = p_A + bendPull<double>(m_frame.extension, p_A).d;
    return radians(m_frame.extension.angle * bendShare(m_frame.extension, p_A).value
                   + m_frame.flexion.angle * bendShare(m_frame.flexion, extended).value);
}

RigidTransform outOfNeck(const NeckField& neck, const RigidTransform& X_AF)
{
    return (neck.X_AU() * X_AF).inverse();
}

Vec3 bentInBody(const NeckField& neck, const RigidTransform& X_AF, const Vec3& p_F)
{
    return outOfNeck(neck, X_AF) * neck.placed(X_AF * p_F);
}

HeadPose<double> headPose(const NeckField& neck)
{
    return {neck.X_AU().rotation().toRotationMatrix(), neck.X_AU().translation()};
}

NeckFrame<float> inSingle(const NeckFrame<double>& frame)
{
    return {bendInSingle(frame.extension), bendInSingle(frame.flexion)};
}

HeadPose<float> inSingle(const HeadPose<double>& head)
{
    return {head.turn.cast<float>(), head.shift.cast<float>()};
}

TriangleMesh deformed(const TriangleMesh& mesh_A, const NeckField& neck)
{
    if (!neck.isBent())
        return mesh_A;
    return movedMesh(mesh_A, [frame = inSingle(neck.frame())](const Vector3<float>& p_A) {
        return neckPull<float>(frame, p_A);
    });
}

} // namespace carina
