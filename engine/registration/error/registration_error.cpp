#include "engine/registration/error/registration_error.h"

#include <Eigen/Eigenvalues>

#include <algorithm>

namespace carina
{

Result<RegistrationError> registrationError(std::span<const Vec3> p_AQ, std::span<const Mat3> R_AS,
                                            const Mat3& tip_S, Length fre,
                                            std::span<const LocalisationError> earlier,
                                            Length least)
{
    if (p_AQ.size() < 3)
        return fail(Errc::TooFewLandmarks, std::to_string(p_AQ.size()));
    RegistrationError error{.own = localisationError(fre, p_AQ.size())};
    error.own.rms = std::max(error.own.rms, least);
    error.touch = pooled(error.own, earlier);
    const std::vector<LandmarkError> landmarks = equalErrors(p_AQ, error.touch.fle.rms);
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
