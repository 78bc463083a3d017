#include "engine/registration/fit/rigid_fit.h"

#include "engine/registration/fit/point_check.h"

#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <optional>

namespace carina
{
namespace
{

/// Singular values of the cross-covariance that differ by less than this share of the largest are
/// equal.
constexpr double kEqualShare = 1e-9;

/// What a fit needs of its pairs, whatever their number: means, and sums over the distances d from
/// them.
struct Moments {
    Vec3 p_A_mean = Vec3::Zero();
    Vec3 p_M_mean = Vec3::Zero();
    Mat3 cross_AM = Mat3::Zero(); ///< sum of d_A d_M^T
    double squares_A = 0.0;       ///< sum of |d_A|^2
    double squares_M = 0.0;
};

Moments momentsOf(std::span<const LandmarkPair> pairs)
{
    Moments moments;
    const double share = 1.0 / double(pairs.size());
    for (const LandmarkPair& pair : pairs) {
        moments.p_A_mean += pair.p_AQ;
        moments.p_M_mean += pair.p_MQ;
    }
    moments.p_A_mean *= share;
    moments.p_M_mean *= share;
    for (const LandmarkPair& pair : pairs) {
        const Vec3 d_A = pair.p_AQ - moments.p_A_mean;
        const Vec3 d_M = pair.p_MQ - moments.p_M_mean;
        moments.cross_AM.noalias() += d_A * d_M.transpose();
        moments.squares_A += d_A.squaredNorm();
        moments.squares_M += d_M.squaredNorm();
    }
    return moments;
}

Result<void> checkPairs(std::span<const LandmarkPair> pairs)
{
    if (pairs.size() < 3)
        return fail(Errc::TooFewLandmarks,
                    std::to_string(pairs.size()) + " landmarks, and 3 are the fewest");
    for (const LandmarkPair& pair : pairs) {
        if (isInRoom(pair.p_AQ) && isInRoom(pair.p_MQ))
            continue;
        if (const auto sound = checkPoint(pair.p_AQ, "a landmark of the anatomy"); !sound)
            return sound;
        return checkPoint(pair.p_MQ, "a landmark of the manikin");
    }
    return {};
}

/// Whether the cross-covariance alone tells that both sets spread along two directions. Its second
/// singular value is at least the root of its determinant over its norm, and at most the second
/// extent of either set times the first of the other (both as roots of sums).
bool bothClearlySpread(const Moments& moments, std::size_t count)
{
    const double least = 3.0 * double(count) * kSmallestExtent.si * kSmallestExtent.si;
    const double second = // squared; NaN where all is zero
        moments.cross_AM.determinant() / moments.cross_AM.norm();
    return std::min(moments.squares_A, moments.squares_M) > least
           && second > kCollinearShare * kCollinearShare * moments.squares_A * moments.squares_M;
}

Result<void> checkBothSpread(std::span<const LandmarkPair> pairs, const Moments& moments)
{
    if (bothClearlySpread(moments, pairs.size()))
        return {};
    Mat3 scatter_A = Mat3::Zero();
    Mat3 scatter_M = Mat3::Zero();
    for (const LandmarkPair& pair : pairs) {
        const Vec3 d_A = pair.p_AQ - moments.p_A_mean;
        const Vec3 d_M = pair.p_MQ - moments.p_M_mean;
        scatter_A += d_A * d_A.transpose() / double(pairs.size());
        scatter_M += d_M * d_M.transpose() / double(pairs.size());
    }
    if (const auto spread = checkSpread(scatter_A, "the anatomy's"); !spread)
        return spread;
    return checkSpread(scatter_M, "the manikin's");
}

/// The rotation nearest to a matrix, by Newton's iteration for its polar factor with Higham's
/// scaling (1986): several times as fast as an SVD. Nothing where the matrix mirrors or is too flat
/// for it.
std::optional<Mat3> polarRotation(const Mat3& matrix)
{
    constexpr double kLeastShare = 1e-4; // of the determinant: the flattest side is a hundredth
    constexpr double kSettled = 1e-8;    // each step leaves the square of it
    const double size = matrix.norm();
    if (!(matrix.determinant() > kLeastShare * size * size * size))
        return std::nullopt;
    Mat3 R = matrix / size;
    for (double step = 1.0; step > kSettled;) {
        const Mat3 inverse = R.inverse();
        const double scale = std::sqrt(inverse.norm() / R.norm());
        const Mat3 next = 0.5 * (scale * R + inverse.transpose() / scale);
        step = (next - R).norm();
        R = next;
    }
    return R;
}

/// The proper R_AM that brings the landmarks nearest; nothing where it is not the only one.
std::optional<Mat3> rotationFrom(const Mat3& cross_AM)
{
    if (const auto R_AM = polarRotation(cross_AM))
        return R_AM;
    const Eigen::JacobiSVD<Mat3> svd{cross_AM, Eigen::ComputeFullU | Eigen::ComputeFullV};
    const Mat3 R_AM = svd.matrixU() * svd.matrixV().transpose();
    const double sign = R_AM.determinant() < 0.0 ? -1.0 : 1.0;
    // Any turn about the first axis fits as well where the other two gain nothing by it.
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
    if (const auto spread = checkBothSpread(pairs, moments); !spread)
        return tl::unexpected(spread.error());
    const std::optional<Mat3> R_AM = rotationFrom(moments.cross_AM);
    if (!R_AM)
        return fail(Errc::DegenerateLandmarks, "more than one turn fits them equally well");

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
