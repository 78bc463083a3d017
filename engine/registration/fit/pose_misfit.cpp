#include "engine/registration/fit/pose_misfit.h"

#include <Eigen/SVD>

#include <algorithm>

namespace carina
{

double poseMisfit(std::span<const LandmarkPair> pairs)
{
    if (pairs.size() < 2)
        return 0.0;
    const double share = 1.0 / double(pairs.size());
    Vec3 p_A_mean = Vec3::Zero();
    Vec3 p_M_mean = Vec3::Zero();
    for (const LandmarkPair& pair : pairs) {
        p_A_mean += share * pair.p_AQ;
        p_M_mean += share * pair.p_MQ;
    }
    Mat3 cross_AM = Mat3::Zero();
    double squares = 0.0;
    for (const LandmarkPair& pair : pairs) {
        const Vec3 d_A = pair.p_AQ - p_A_mean;
        const Vec3 d_M = pair.p_MQ - p_M_mean;
        cross_AM += d_A * d_M.transpose();
        squares += d_A.squaredNorm() + d_M.squaredNorm();
    }
    const Vec3 values = Eigen::JacobiSVD<Mat3>{cross_AM}.singularValues();
    const double sign = cross_AM.determinant() < 0.0 ? -1.0 : 1.0;
    return std::max(0.0, squares - 2.0 * (values[0] + values[1] + sign * values[2]));
}

} // namespace carina
