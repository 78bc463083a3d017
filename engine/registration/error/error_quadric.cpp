#include "engine/registration/error/error_quadric.h"

namespace carina
{

Mat4 errorQuadric(const Mat6& covariance_A)
{
    const Mat3 turns = covariance_A.topLeftCorner<3, 3>();
    const Mat3 mixed = covariance_A.bottomLeftCorner<3, 3>(); // E[v w^T]
    const Vec3 c{mixed(1, 2) - mixed(2, 1), mixed(2, 0) - mixed(0, 2), mixed(0, 1) - mixed(1, 0)};
    Mat4 quadric;
    quadric << turns.trace() * Mat3::Identity() - turns, c, //
        c.transpose(), covariance_A.bottomRightCorner<3, 3>().trace();
    return quadric;
}

} // namespace carina
