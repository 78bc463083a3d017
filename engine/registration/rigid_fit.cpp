#include "engine/registration/rigid_fit.h"

#include "engine/registration/point_check.h"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

#include <cmath>
#include <optional>

namespace carina
{
namespace
{

/// Singular values of the cross-covariance that differ by less than this share of the largest are
/// equal.
constexpr double kEqualShare = 1e-9;

struct Centred {
    Vec3 centroid = Vec3::Zero();
    Eigen::Matrix3Xd offsets;
};

Centred centred(std::span<const LandmarkPair> pairs, Vec3 LandmarkPair::*point)
{
    Centred set;
    set.offsets.resize(3, Eigen::Index(pairs.size()));
    for (const LandmarkPair& pair : pairs)
        set.centroid += pair.*point / double(pairs.size());
    for (std::size_t i = 0; i < pairs.size(); ++i)
        set.offsets.col(Eigen::Index(i)) = pairs[i].*point - set.centroid;
    return set;
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

/// Whether points spread along two directions, from the eigenvalues of their scatter, which are
/// squares of extents.
Result<void> checkSpread(const Eigen::Matrix3Xd& offsets, const std::string& whose)
{
    const Mat3 scatter = offsets * offsets.transpose() / double(offsets.cols());
    const Vec3 squares = // ascending
        Eigen::SelfAdjointEigenSolver<Mat3>{scatter, Eigen::EigenvaluesOnly}.eigenvalues();
    if (squares[2] < kSmallestExtent.si * kSmallestExtent.si)
        return fail(Errc::DegenerateLandmarks, whose + " landmarks lie at one place");
    if (squares[1] < kCollinearShare * kCollinearShare * squares[2])
        return fail(Errc::DegenerateLandmarks, whose + " landmarks lie on one line");
    return {};
}

/// The proper R_AM that brings the offsets nearest; nothing where it is not the only one.
std::optional<Mat3> rotationBetween(const Eigen::Matrix3Xd& anatomy,
                                    const Eigen::Matrix3Xd& manikin)
{
    const Mat3 covariance = manikin * anatomy.transpose();
    const Eigen::JacobiSVD<Mat3> svd{covariance, Eigen::ComputeFullU | Eigen::ComputeFullV};
    const Mat3 R_AM = svd.matrixV() * svd.matrixU().transpose();
    const double sign = R_AM.determinant() < 0.0 ? -1.0 : 1.0;
    // Any turn about the first axis fits as well where the other two gain nothing by it.
    const Vec3 values = svd.singularValues();
    if (values[1] + sign * values[2] <= kEqualShare * values[0])
        return std::nullopt;
    return svd.matrixV() * Vec3{1.0, 1.0, sign}.asDiagonal() * svd.matrixU().transpose();
}

} // namespace

Result<RigidFit> fitRigid(std::span<const LandmarkPair> pairs)
{
    if (const auto sound = checkPairs(pairs); !sound)
        return tl::unexpected(sound.error());
    const Centred anatomy = centred(pairs, &LandmarkPair::p_AQ);
    const Centred manikin = centred(pairs, &LandmarkPair::p_MQ);
    if (const auto spread = checkSpread(anatomy.offsets, "the anatomy's"); !spread)
        return tl::unexpected(spread.error());
    if (const auto spread = checkSpread(manikin.offsets, "the manikin's"); !spread)
        return tl::unexpected(spread.error());
    const std::optional<Mat3> R_AM = rotationBetween(anatomy.offsets, manikin.offsets);
    if (!R_AM)
        return fail(Errc::DegenerateLandmarks, "more than one turn fits them equally well");

    RigidFit fit{.X_AM = RigidTransform{Quat{*R_AM}, anatomy.centroid - *R_AM * manikin.centroid}};
    double squares = 0.0;
    for (const LandmarkPair& pair : pairs) {
        fit.residuals.push_back((pair.p_AQ - fit.X_AM * pair.p_MQ).norm());
        squares += fit.residuals.back() * fit.residuals.back();
    }
    fit.rms = std::sqrt(squares / double(pairs.size()));
    return fit;
}

} // namespace carina
