#include "engine/geometry/fit/weighted_fit.h"

#include "engine/geometry/fit/point_check.h"
#include "engine/geometry/rotation.h"

#include <Eigen/Cholesky>

#include <cmath>

namespace carina
{
namespace
{

/// The normal equations of one step about a place: (w, v) = inverse * gradient.
struct StepEquations {
    Mat6 normal = Mat6::Zero();
    Vec6 gradient = Vec6::Zero();
    double chiSquared = 0.0;
};

StepEquations equationsAt(std::span<const UncertainPair> pairs, const RigidTransform& X_AM,
                          const Vec3& p_A_about)
{
    StepEquations equations;
    const Mat3 R_AM = X_AM.rotation().toRotationMatrix();
    for (const UncertainPair& landmark : pairs) {
        const Vec3 p_A = X_AM * landmark.pair.p_MQ;
        const Vec3 e_A = landmark.pair.p_AQ - p_A;
        const Mat3 covariance =
            landmark.covariance_A + R_AM * landmark.covariance_M * R_AM.transpose();
        const Mat3 weight = covariance.inverse();
        Eigen::Matrix<double, 3, 6> moved;
        moved << -crossMatrix(p_A - p_A_about), Mat3::Identity();
        equations.normal += moved.transpose() * weight * moved;
        equations.gradient += moved.transpose() * weight * e_A;
        equations.chiSquared += e_A.dot(weight * e_A);
    }
    return equations;
}

/// X_AM after a small motion of A's points about a place.
RigidTransform stepped(const RigidTransform& X_AM, const Vec6& motion, const Vec3& p_A_about)
{
    const Quat turn = rotationFromVector(motion.head<3>());
    return {turn * X_AM.rotation(),
            p_A_about + turn * (X_AM.translation() - p_A_about) + motion.tail<3>()};
}

Result<RigidTransform> atRest(std::span<const UncertainPair> pairs, RigidTransform X_AM,
                              const Vec3& p_A_about)
{
    constexpr int kMostSteps = 100;
    constexpr double kAtRest = 1e-12;    // metres and radians
    constexpr double kLongestStep = 1.0; // from the fit of equal weights; metres and radians
    for (int i = 0; i < kMostSteps; ++i) {
        const StepEquations equations = equationsAt(pairs, X_AM, p_A_about);
        const Vec6 motion = equations.normal.ldlt().solve(equations.gradient);
        if (!(motion.norm() < kLongestStep))
            break;
        X_AM = stepped(X_AM, motion, p_A_about);
        if (motion.norm() < kAtRest)
            return X_AM;
    }
    return fail(Errc::DegenerateLandmarks, "their covariances contradict their places");
}

/// What the fit leaves, and how sure it is.
WeightedFit described(std::span<const UncertainPair> pairs, const RigidTransform& X_AM)
{
    WeightedFit weighted{.fit = {.X_AM = X_AM}};
    double squares = 0.0;
    for (const UncertainPair& landmark : pairs) {
        const double square = (landmark.pair.p_AQ - X_AM * landmark.pair.p_MQ).squaredNorm();
        weighted.fit.residuals.push_back(std::sqrt(square));
        squares += square;
    }
    weighted.fit.rms = std::sqrt(squares / double(pairs.size()));
    const StepEquations equations = equationsAt(pairs, X_AM, Vec3::Zero());
    weighted.covariance_A = equations.normal.ldlt().solve(Mat6::Identity());
    weighted.chiSquared = equations.chiSquared;
    weighted.degrees = 3.0 * double(pairs.size()) - 6.0;
    return weighted;
}

} // namespace

Result<WeightedFit> fitWeighted(std::span<const UncertainPair> pairs)
{
    std::vector<LandmarkPair> unweighted;
    Vec3 p_A_mean = Vec3::Zero();
    for (const UncertainPair& landmark : pairs) {
        unweighted.push_back(landmark.pair);
        p_A_mean += landmark.pair.p_AQ / double(pairs.size());
        if (const auto sound = checkCovariance(landmark.covariance_A + landmark.covariance_M);
            !sound)
            return tl::unexpected(sound.error());
    }
    const Result<RigidFit> start = fitRigid(unweighted);
    if (!start)
        return tl::unexpected(start.error());
    const Result<RigidTransform> X_AM = atRest(pairs, start->X_AM, p_A_mean);
    if (!X_AM)
        return tl::unexpected(X_AM.error());
    return described(pairs, *X_AM);
}

} // namespace carina
