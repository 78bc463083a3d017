#include "engine/anatomy/airway/jaw_hinge.h"

#include "engine/geometry/rotation.h"

#include <utility>

namespace carina
{
namespace
{

/// Midway between the condyles, from the edge of the upper incisors, in reference millimetres.
const Vec3 kHinge{0.0, 87.0, 45.0};

// The lower incisors are 98 mm from the hinge: 11.7 degrees take them 20 mm down and back.
constexpr Angle kHeldOpen = degrees(11.7);

} // namespace

RigidTransform heldJaw(const BodyPlan& plan)
{
    if (plan.posture == Posture::Rest)
        return {};
    const Vec3 hinge = plan.inFace(kHinge);
    return RigidTransform::translation(hinge)
           * RigidTransform{rotationFromVector(kHeldOpen.si * Vec3::UnitX()), Vec3::Zero()}
           * RigidTransform::translation(-hinge);
}

ImplicitShape onJaw(const BodyPlan& plan, ImplicitShape shut)
{
    const RigidTransform X_AJ = heldJaw(plan);
    Box bounds;
    for (int corner = 0; corner < 8; ++corner)
        bounds.include(X_AJ
                       * Vec3{(corner & 1) != 0 ? shut.bounds.max.x() : shut.bounds.min.x(),
                              (corner & 2) != 0 ? shut.bounds.max.y() : shut.bounds.min.y(),
                              (corner & 4) != 0 ? shut.bounds.max.z() : shut.bounds.min.z()});
    return {bounds, [X_JA = X_AJ.inverse(), distance = std::move(shut.distance)](const Vec3& p_A) {
                return distance(X_JA * p_A);
            }};
}

} // namespace carina
