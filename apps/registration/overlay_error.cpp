#include "apps/registration/overlay_error.h"

namespace carina
{

double overlayError(const RigidTransform& X_AT, const RigidTransform& X_TA, const Vec3& p_AQ)
{
    return (X_AT * (X_TA * p_AQ) - p_AQ).norm();
}

} // namespace carina
