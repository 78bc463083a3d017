#include "engine/anatomy/airway/jaw_reach.h"

#include "engine/geometry/rotation.h"

namespace carina
{

bool isInReachOfJaw(const RigidTransform& X_AJ, const Vec3& p_A_incisors, double size)
{
    const double way = (X_AJ * p_A_incisors - p_A_incisors).norm();
    return way <= size * kFarthestJaw.si && angleOf(X_AJ.rotation()) <= kMostJawTurn;
}

} // namespace carina
