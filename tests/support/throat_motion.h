#pragma once

#include "engine/geometry/deformation/throat_field.h"

namespace carina::test
{

/// The displacement of a throat at a point and its gradient, by the formula that deformed() and the
/// vertex shader use, in double precision.
inline FieldDisplacement throatAt(const ThroatField& throat, const Vec3& p_A,
                                  const RigidTransform& X_AJ, ThroatTissue tissue)
{
    const DisplacementAt<double> pull = jawPull(throat.frame(), tissue, jawShift(X_AJ), p_A);
    return {pull.d, pull.gradient};
}

/// The share S by which a point follows the jaw, 0 to 1.
inline double throatShare(const ThroatField& throat, const Vec3& p_A, ThroatTissue tissue)
{
    return jawShare(throat.frame(), tissue, p_A).value;
}

} // namespace carina::test
