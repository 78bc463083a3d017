#include "engine/registration/error/registration_error.h"

#include "engine/core/expects.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

/// Of the error of one touch, m^2.
double squareOf(Length seen) { return std::pow(std::max(seen, kLeastFle).si, 2); }

/// Mean of the squares of those that are known, m^2.
double meanSquareOf(std::span<const std::optional<Length>> seen)
{
    double sum = 0.0;
    int known = 0;
    for (const std::optional<Length>& each : seen) {
        sum += each ? squareOf(*each) : 0.0;
        known += each ? 1 : 0;
    }
    return known > 0 ? sum / known : squareOf(kLeastFle);
}

} // namespace

Result<RegistrationError> registrationError(std::span<const Vec3> p_AQ, std::span<const Mat3> R_AS,
                                            const Mat3& tip_S, Length fre,
                                            std::span<const LocalisationError> earlier,
                                            std::span<const std::optional<Length>> seen)
{
    CARINA_EXPECTS(seen.empty() || seen.size() == p_AQ.size());
    if (p_AQ.size() < 3)
        return fail(Errc::TooFewLandmarks, std::to_string(p_AQ.size()));
    RegistrationError error{.own = localisationError(fre, p_AQ.size())};
    const double meanSquare = meanSquareOf(seen);
    const Length least = metres(std::sqrt(meanSquare));
    error.own.rms = std::max(error.own.rms, least);
    error.touch = pooled(error.own, earlier);
    error.touch.fle.rms = std::max(error.touch.fle.rms, least); // this time it was seen so
    std::vector<LandmarkError> landmarks = equalErrors(p_AQ, error.touch.fle.rms);
    for (std::size_t i = 0; i < seen.size(); ++i)
        if (seen[i])
            landmarks[i].covariance_A += (squareOf(*seen[i]) - meanSquare) / 3.0 * Mat3::Identity();
    const Result<Mat6> touches = fitCovariance(landmarks);
    if (!touches)
        return tl::unexpected(touches.error());
    error.covariance_A = *touches;
    if (tip_S.isZero())
        return error;
    const Result<Mat6> tip = sharedCovariance(landmarks, R_AS, tip_S);
    if (!tip)
        return tl::unexpected(tip.error());
    error.covariance_A += *tip;
    return error;
}

Mat6 refinedCovariance(const Mat6& before_A, const SurfaceRefinement& refinement, const Mat3& tip_S)
{
    Mat6 toOrigin = Mat6::Identity(); // of motions about the swab's centre
    toOrigin.bottomLeftCorner<3, 3>() = crossMatrix(refinement.p_AC);
    Mat6 toCentre = Mat6::Identity();
    toCentre.bottomLeftCorner<3, 3>() = -crossMatrix(refinement.p_AC);

    Mat6 scaled = Mat6::Identity(); // turns as ways
    scaled.topLeftCorner<3, 3>() *= refinement.extent;
    Mat6 loose = Mat6::Zero();
    for (const SmallMotion& motion : refinement.loose) {
        Eigen::Matrix<double, 6, 1> direction;
        direction << motion.turn_A, motion.shift_A;
        loose += direction * direction.transpose();
    }
    const Mat6 slides = scaled.inverse() * loose * scaled;
    const Mat6 keep = slides * toCentre;
    const auto held = (Mat6::Identity() - slides).rightCols<3>().eval(); // of a shift
    const double tip =
        Eigen::SelfAdjointEigenSolver<Mat3>{tip_S, Eigen::EigenvaluesOnly}.eigenvalues()[2];
    const Mat6 about = refinement.covariance + keep * before_A * keep.transpose()
                       + std::max(tip, 0.0) * held * held.transpose();
    return toOrigin * about * toOrigin.transpose();
}

} // namespace carina
