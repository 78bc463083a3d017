#include "engine/anatomy/jaw_hinge.h"

#include "engine/geometry/rotation.h"

#include <utility>

namespace carina
{

namespace
{

/// Between the condyles, from the edge of the upper incisors, in his millimetres.
const Vec3 kHinge{0.0, 87.0, 45.0};

Mat3 opening(const BodyPlan& plan)
{
    // The lower incisors are 98 mm from the hinge: 11.7 degrees take them 20 mm down and back.
    const Angle angle = plan.posture == Posture::Rest ? Angle{} : degrees(11.7);
    return rotationFromVector(angle.si * Vec3::UnitX()).toRotationMatrix();
}

} // namespace

Vec3 withJaw(const BodyPlan& plan, const Vec3& p_A_shut)
{
    const Vec3 hinge = plan.inFace(kHinge);
    return hinge + opening(plan) * (p_A_shut - hinge);
}

ImplicitShape onJaw(const BodyPlan& plan, ImplicitShape shut)
{
    Box bounds;
    for (int corner = 0; corner < 8; ++corner)
        bounds.include(
            withJaw(plan, {(corner & 1) != 0 ? shut.bounds.max.x() : shut.bounds.min.x(),
                           (corner & 2) != 0 ? shut.bounds.max.y() : shut.bounds.min.y(),
                           (corner & 4) != 0 ? shut.bounds.max.z() : shut.bounds.min.z()}));
    const Vec3 hinge = plan.inFace(kHinge);
    return {bounds,
            [hinge, back = Mat3{opening(plan).transpose()}, distance = std::move(shut.distance)](
                const Vec3& p_A) { return distance(hinge + back * (p_A - hinge)); }};
}

} // namespace carina
