#include "engine/geometry/fit/rigid_fit.h"

#include "engine/geometry/fit/point_check.h"

#include <Eigen/SVD>

#include <cmath>
#include <optional>

namespace carina
{
namespace
{

/// Singular values of the cross-covariance count as equal where they differ by less than this share
/// of the largest.
constexpr double kEqualShare = 1e-9;

/// Means of the landmarks, and mean products of the differences d from them.
struct Moments {
    Vec3 p_A_mean = Vec3::Zero();
    Vec3 p_M_mean = Vec3::Zero();
    Mat3 cross_AM = Mat3::Zero();  ///< cross-covariance: mean of d_A d_M^T, m^2
    Mat3 scatter_A = Mat3::Zero(); ///< mean of d_A d_A^T, m^2
    Mat3 scatter_M = Mat3::Zero();
};

Moments momentsOf(std::span<const LandmarkPair> pairs)
{
    const double share = 1.0 / double(pairs.size());
    Moments moments;
    for (const LandmarkPair& pair : pairs) {
        moments.p_A_mean += share * pair.p_AQ;
        moments.p_M_mean += share * pair.p_MQ;
    }
    for (const LandmarkPair& pair : pairs) {
        const Vec3 d_A = pair.p_AQ - moments.p_A_mean;
        const Vec3 d_M = pair.p_MQ - moments.p_M_mean;
        moments.cross_AM.noalias() += share * d_A * d_M.transpose();
        moments.scatter_A.noalias() += share * d_A * d_A.transpose();
        moments.scatter_M.noalias() += share * d_M * d_M.transpose();
    }
    return moments;
}

Result<void> checkPairs(std::span<const LandmarkPair> pairs)
{
    if (pairs.size() < 3)
        return fail(Errc::TooFewLandmarks,
                    std::to_string(pairs.size()) + " landmarks, and 3 are the fewest");
    for (const LandmarkPair& pair : pairs) {
        if (const auto sound = checkPoint(pair.p_AQ, "a landmark of the anatomy"); !sound)
            return sound;
        if (const auto sound = checkPoint(pair.p_MQ, "a landmark of the manikin"); !sound)
            return sound;
    }
    return {};
}

/// The proper R_AM of the least-squares fit; std::nullopt where it is not unique.
std::optional<Mat3> rotationFrom(const Mat3& cross_AM)
{
    const Eigen::JacobiSVD<Mat3> svd{cross_AM, Eigen::ComputeFullU | Eigen::ComputeFullV};
    const Mat3 R_AM = svd.matrixU() * svd.matrixV().transpose();
    const double sign = R_AM.determinant() < 0.0 ? -1.0 : 1.0;
    // Where the second and third singular values cancel, every rotation about the first axis fits.
    const Vec3 values = svd.singularValues();
    if (values[1] + sign * values[2] <= kEqualShare * values[0])
        return std::nullopt;
    return svd.matrixU() * Vec3{1.0, 1.0, sign}.asDiagonal() * svd.matrixV().transpose();
}

} // namespace

Result<RigidFit> fitRigid(std::span<const LandmarkPair> pairs)
{
    if (const auto sound = checkPairs(pairs); !sound)
        return tl::unexpected(sound.error());
    const Moments moments = momentsOf(pairs);
    if (const auto spread = checkSpread(moments.scatter_A, "the anatomy's"); !spread)
        return tl::unexpected(spread.error());
    if (const auto spread = checkSpread(moments.scatter_M, "the manikin's"); !spread)
        return tl::unexpected(spread.error());
    const std::optional<Mat3> R_AM = rotationFrom(moments.cross_AM);
    if (!R_AM)
        return fail(Errc::DegenerateLandmarks, "more than one rotation fits them equally well");

    RigidFit fit{.X_AM = {Quat{*R_AM}, moments.p_A_mean - *R_AM * moments.p_M_mean},
                 .residuals = std::vector<double>(pairs.size())};
    double squares = 0.0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const Vec3 d_A = pairs[i].p_AQ - moments.p_A_mean;
        const double square = (d_A - *R_AM * (pairs[i].p_MQ - moments.p_M_mean)).squaredNorm();
        fit.residuals[i] = std::sqrt(square);
        squares += square;
    }
    fit.rms = std::sqrt(squares / double(pairs.size()));
    return fit;
}

} // namespace carina
