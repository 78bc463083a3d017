#include "engine/registration/watch/re_registration.h"

#include "engine/core/expects.h"
#include "engine/registration/fit/pose_misfit.h"
#include "engine/registration/landmarks/landmark_order.h"

#include <Eigen/Cholesky>

#include <cmath>
#include <limits>
#include <set>

namespace carina
{
namespace
{

using Mat63 = Eigen::Matrix<double, 6, 3>;

/// As pairs of where a touch was in M and where it is now in T.
std::vector<LandmarkPair> pairsOf(const EarlierRegistration& earlier,
                                  std::span<const Retouch> touches)
{
    std::vector<LandmarkPair> pairs;
    for (const Retouch& touch : touches)
        pairs.push_back({earlier.landmarks[touch.landmark].p_MQ, touch.p_TQ});
    return pairs;
}

/// The touch without which the others agree best.
std::size_t standingOut(std::span<const LandmarkPair> pairs)
{
    std::size_t worst = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t out = 0; out < pairs.size(); ++out) {
        std::vector<LandmarkPair> others{pairs.begin(), pairs.end()};
        others.erase(others.begin() + std::ptrdiff_t(out));
        if (const double misfit = poseMisfit(others); misfit < least) {
            least = misfit;
            worst = out;
        }
    }
    return worst;
}

/// What is wrong with touches that do not agree with those before, in words.
std::string fault(const EarlierRegistration& earlier, std::span<const Retouch> touches,
                  std::span<const LandmarkPair> pairs, const OrderFinding& finding)
{
    const auto name = [&](std::size_t touch) {
        return "\"" + earlier.landmarks[touches[touch].landmark].name + "\"";
    };
    if (finding.order != TouchOrder::Exchanged)
        return name(standingOut(pairs)) + " is not as far from the others as it was";
    std::string exchanged;
    for (std::size_t i = 0; i < touches.size(); ++i) {
        if (finding.touchOf[i] != i)
            exchanged += (exchanged.empty() ? "" : ", ") + name(i);
    }
    return exchanged + " were touched in another order";
}

/// How a fit moves for an error at each of some landmarks: S^-1 J^T, about A's origin.
std::vector<Mat63> gainsOf(std::span<const Vec3> p_AQ)
{
    Vec3 p_A_mean = Vec3::Zero();
    for (const Vec3& p : p_AQ)
        p_A_mean += p / double(p_AQ.size());
    Mat6 normal = Mat6::Zero();
    std::vector<Mat63> gains;
    for (const Vec3& p : p_AQ) {
        Mat63 transposed; // of w x d + v
        transposed << crossMatrix(p - p_A_mean), Mat3::Identity();
        normal += transposed * transposed.transpose();
        gains.push_back(transposed);
    }
    Mat6 fromOrigin = Mat6::Identity(); // v' = v - w x mean
    fromOrigin.bottomLeftCorner<3, 3>() = crossMatrix(p_A_mean);
    const Mat6 solved = fromOrigin * normal.ldlt().solve(Mat6::Identity());
    for (Mat63& gain : gains)
        gain = solved * gain;
    return gains;
}

Mat6 covarianceOf(const EarlierRegistration& earlier, std::span<const Retouch> touches,
                  const TouchErrors& errors)
{
    const auto variance = [](Length fle) { return fle.si * fle.si / 3.0; };
    std::vector<Vec3> all;
    for (const RegisteredLandmark& landmark : earlier.landmarks)
        all.push_back(landmark.p_AQ);
    std::vector<Vec3> some;
    for (const Retouch& touch : touches)
        some.push_back(all[touch.landmark]);
    const std::vector<Mat63> first = gainsOf(all);
    const std::vector<Mat63> again = gainsOf(some);

    Mat6 covariance = earlier.covariance_A.value_or(Mat6::Zero());
    if (earlier.covariance_A) { // nothing cancels: what it was refined by is not touched again
        for (const Mat63& gain : again)
            covariance +=
                (variance(errors.first) + variance(errors.again)) * gain * gain.transpose();
        return covariance;
    }
    std::vector<Mat63> kept = first; // of the errors of the first touches
    for (std::size_t j = 0; j < touches.size(); ++j) {
        kept[touches[j].landmark] -= again[j];
        covariance += variance(errors.again) * again[j] * again[j].transpose();
    }
    for (std::size_t i = 0; i < all.size(); ++i) {
        covariance += variance(errors.first) * kept[i] * kept[i].transpose();
        covariance += variance(errors.place) * first[i] * first[i].transpose();
    }
    return covariance;
}

void expectSound(const EarlierRegistration& earlier, std::span<const Retouch> touches,
                 const TouchErrors& errors)
{
    CARINA_EXPECTS(errors.first.si > 0.0 && errors.again.si > 0.0 && errors.place.si >= 0.0);
    std::set<std::size_t> touched;
    for (const Retouch& touch : touches) {
        CARINA_EXPECTS(touch.landmark < earlier.landmarks.size());
        CARINA_EXPECTS(touched.insert(touch.landmark).second);
    }
}

} // namespace

Result<ReRegistration> reRegister(const EarlierRegistration& earlier,
                                  std::span<const Retouch> touches, const TouchErrors& errors)
{
    expectSound(earlier, touches, errors);
    const std::vector<LandmarkPair> pairs = pairsOf(earlier, touches);
    const Length apart = metres(std::hypot(errors.first.si, errors.again.si));
    const Result<OrderFinding> finding = recogniseOrder(pairs, apart);
    if (!finding)
        return tl::unexpected(finding.error());
    const Result<RigidFit> fit = fitRigid(pairs);
    if (!fit && finding->order != TouchOrder::Exchanged)
        return fail(fit.error().code, "those touched again lie on one line or at one place");
    if (finding->order != TouchOrder::AsGiven)
        return fail(Errc::DegenerateLandmarks, fault(earlier, touches, pairs, *finding));

    const RigidTransform& X_MT = fit->X_AM; // of p_MQ and p_TQ
    return ReRegistration{.X_TM = X_MT.inverse(),
                          .X_AT = earlier.X_AM * X_MT,
                          .residuals = fit->residuals,
                          .rms = fit->rms,
                          .covariance_A = covarianceOf(earlier, touches, errors),
                          .explanations = finding->explanations};
}

} // namespace carina
