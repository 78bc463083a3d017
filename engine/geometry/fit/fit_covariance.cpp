#include "engine/geometry/fit/fit_covariance.h"

#include "engine/core/expects.h"
#include "engine/geometry/fit/point_check.h"

#include <Eigen/Cholesky>

namespace carina
{
namespace
{

using Mat36 = Eigen::Matrix<double, 3, 6>;

/// What a fit makes of errors at its landmarks: motions (w, v) about their mean.
struct FirstOrder {
    Vec3 p_A_mean = Vec3::Zero();
    Mat6 inverse = Mat6::Zero();   ///< S^-1
    std::vector<Mat36> weighted{}; ///< W J of each landmark

    /// Counted from A's origin instead of the mean: v' = v - w x mean.
    [[nodiscard]] Mat6 fromOrigin(const Mat6& aboutMean) const
    {
        Mat6 shift = Mat6::Identity();
        shift.bottomLeftCorner<3, 3>() = crossMatrix(p_A_mean);
        return shift * aboutMean * shift.transpose();
    }
};

Result<void> checkErrors(std::span<const LandmarkError> landmarks)
{
    if (landmarks.size() < 3)
        return fail(Errc::TooFewLandmarks,
                    std::to_string(landmarks.size()) + " landmarks, and 3 are the fewest");
    for (const LandmarkError& landmark : landmarks) {
        if (const auto sound = checkPoint(landmark.p_AQ, "a landmark of the anatomy"); !sound)
            return sound;
        if (const auto sound = checkCovariance(landmark.covariance_A); !sound)
            return sound;
    }
    return {};
}

Mat3 weightOf(const LandmarkError& landmark, Weighting weighting)
{
    if (weighting == Weighting::Alike)
        return Mat3::Identity();
    return landmark.covariance_A.inverse();
}

Result<FirstOrder> firstOrderOf(std::span<const LandmarkError> landmarks, Weighting weighting)
{
    if (const auto sound = checkErrors(landmarks); !sound)
        return tl::unexpected(sound.error());
    FirstOrder fit;
    const double share = 1.0 / double(landmarks.size());
    for (const LandmarkError& landmark : landmarks)
        fit.p_A_mean += share * landmark.p_AQ;
    Mat3 scatter = Mat3::Zero();
    Mat6 normal = Mat6::Zero();
    for (const LandmarkError& landmark : landmarks) {
        const Vec3 d_A = landmark.p_AQ - fit.p_A_mean;
        scatter += share * d_A * d_A.transpose();
        Mat36 moved;
        moved << -crossMatrix(d_A), Mat3::Identity();
        const Mat3 weight = weightOf(landmark, weighting);
        fit.weighted.push_back(weight * moved);
        normal += moved.transpose() * fit.weighted.back();
    }
    if (const auto spread = checkSpread(scatter, "the anatomy's"); !spread)
        return tl::unexpected(spread.error());
    fit.inverse = normal.ldlt().solve(Mat6::Identity());
    return fit;
}

} // namespace

std::vector<LandmarkError> equalErrors(std::span<const Vec3> p_AQ, Length fle)
{
    std::vector<LandmarkError> landmarks;
    for (const Vec3& p : p_AQ)
        landmarks.push_back({p, (fle.si * fle.si / 3.0) * Mat3::Identity()});
    return landmarks;
}

Result<Mat6> fitCovariance(std::span<const LandmarkError> landmarks, Weighting weighting)
{
    const Result<FirstOrder> fit = firstOrderOf(landmarks, weighting);
    if (!fit)
        return tl::unexpected(fit.error());
    Mat6 middle = Mat6::Zero();
    for (std::size_t i = 0; i < landmarks.size(); ++i)
        middle += fit->weighted[i].transpose() * landmarks[i].covariance_A * fit->weighted[i];
    return fit->fromOrigin(fit->inverse * middle * fit->inverse);
}

Result<Mat6> sharedCovariance(std::span<const LandmarkError> landmarks, std::span<const Mat3> R_AS,
                              const Mat3& covariance_S, Weighting weighting)
{
    CARINA_EXPECTS(R_AS.size() == landmarks.size());
    const Result<FirstOrder> fit = firstOrderOf(landmarks, weighting);
    if (!fit)
        return tl::unexpected(fit.error());
    Eigen::Matrix<double, 6, 3> gain = Eigen::Matrix<double, 6, 3>::Zero();
    for (std::size_t i = 0; i < landmarks.size(); ++i)
        gain += fit->inverse * fit->weighted[i].transpose() * R_AS[i];
    return fit->fromOrigin(gain * covariance_S * gain.transpose());
}

Result<Vec6> fitBias(std::span<const LandmarkError> landmarks, std::span<const Vec3> biases_A,
                     Weighting weighting)
{
    CARINA_EXPECTS(biases_A.size() == landmarks.size());
    const Result<FirstOrder> fit = firstOrderOf(landmarks, weighting);
    if (!fit)
        return tl::unexpected(fit.error());
    Vec6 motion = Vec6::Zero();
    for (std::size_t i = 0; i < landmarks.size(); ++i)
        motion += fit->inverse * (fit->weighted[i].transpose() * biases_A[i]);
    motion.tail<3>() -= motion.head<3>().cross(fit->p_A_mean); // from the mean to A's origin
    return motion;
}

} // namespace carina
