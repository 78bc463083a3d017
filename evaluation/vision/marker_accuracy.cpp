#include "evaluation/vision/marker_accuracy.h"

#include "engine/geometry/rotation.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace carina
{
namespace
{

constexpr Angle kWrong = degrees(10.0);

RigidTransform drawnPose(const AccuracyTrial& trial, std::mt19937& random)
{
    std::uniform_real_distribution<double> uniform{-1.0, 1.0};
    const Vec2 middle{0.5 * trial.camera.width, 0.5 * trial.camera.height};
    const Vec2 pixel = middle + middle.cwiseProduct(Vec2{uniform(random), uniform(random)}) / 1.5;
    const Vec3 sight = sightOf(trial.camera, pixel).normalized();
    const double turn = std::numbers::pi * uniform(random);
    const double towards = std::numbers::pi * uniform(random);
    const double tilt = trial.tilt.si * uniform(random);
    const Quat facing = Quat::FromTwoVectors(Vec3::UnitZ(), -sight);
    Quat q{Eigen::AngleAxisd{tilt, Vec3{std::cos(towards), std::sin(towards), 0.0}}};
    if (trial.isTurning) // its axis from along the line of sight to across it
        q = q * Quat{Eigen::AngleAxisd{0.5 * std::numbers::pi, Vec3::UnitX()}};
    return {facing * q * Quat{Eigen::AngleAxisd{turn, Vec3::UnitZ()}}, trial.distance * sight};
}

/// The small motion (w, v) of points of T that takes the pose found to the true one.
Eigen::Matrix<double, 6, 1> errorOf(const RigidTransform& found, const RigidTransform& truth)
{
    Eigen::Matrix<double, 6, 1> error;
    const Vec3 w = rotationVector(truth.rotation() * found.rotation().conjugate());
    error << w, truth.translation() - found.translation() - w.cross(found.translation());
    return error;
}

/// Adds what the corners' errors amount to. @returns their number.
int addCornerErrors(const AccuracyTrial& trial, const std::vector<DetectedMarker>& seen,
                    const RigidTransform& X_TB, double& squares)
{
    int corners = 0;
    for (const DetectedMarker& marker : seen) {
        const auto of = std::ranges::find(trial.body, marker.id, &BodyMarker::id);
        if (of == trial.body.end())
            continue;
        const auto p_BQ = cornersOf(*of);
        for (std::size_t i = 0; i < p_BQ.size(); ++i) {
            squares +=
                0.5 * (marker.corners[i] - *project(trial.camera, X_TB * p_BQ[i])).squaredNorm();
            ++corners;
        }
    }
    return corners;
}

} // namespace

void AccuracySum::add(const BodySight& sight, const RigidTransform& X_TB)
{
    ++m_sum.poses;
    m_sum.ambiguous += sight.isAmbiguous ? 1 : 0;
    if (!sight.pose || sight.isAmbiguous)
        return;
    ++m_sum.seen;
    const RigidTransform& found = sight.pose->X_TB;
    const double turned = angleBetween(found.rotation(), X_TB.rotation()).si;
    if (turned > kWrong.si) {
        ++m_sum.wrong;
        return;
    }
    const Vec3 off = found.translation() - X_TB.translation();
    const double along = off.dot(X_TB.translation().normalized());
    m_sum.alongRms += along * along;
    m_sum.acrossRms += 0.5 * (off.squaredNorm() - along * along);
    m_sum.rotationRms += turned * turned;
    m_sum.reprojectionRms += sight.pose->rms * sight.pose->rms;
    const auto error = errorOf(found, X_TB);
    m_sum.normalisedSquare += error.dot(sight.pose->covariance_T.ldlt().solve(error)) / 6.0;
}

MarkerAccuracy AccuracySum::result(double distance) const
{
    MarkerAccuracy result = m_sum;
    result.distance = distance;
    const double count = std::max(result.seen - result.wrong, 1);
    for (double* rms :
         {&result.alongRms, &result.acrossRms, &result.rotationRms, &result.reprojectionRms})
        *rms = std::sqrt(*rms / count);
    result.normalisedSquare /= count;
    return result;
}

MarkerAccuracy markerAccuracy(const AccuracyTrial& trial)
{
    MarkerRenderer renderer{trial.camera, trial.dictionary, trial.rendering};
    std::mt19937 random{trial.seed};
    AccuracySum sum;
    double cornerSquares = 0.0;
    int corners = 0;
    for (int i = 0; i < trial.poses; ++i) {
        const RigidTransform X_TB = drawnPose(trial, random);
        const PosedBody placed{&trial.body, X_TB};
        const auto seen = seenMarkers(renderer.draw({&placed, 1}), trial.dictionary);
        corners += addCornerErrors(trial, seen, X_TB, cornerSquares);
        MarkerWatch watch{{trial.camera, trial.dictionary, {trial.body}}};
        sum.add(watch.look(seen, {}).front(), X_TB);
    }
    MarkerAccuracy result = sum.result(trial.distance);
    result.cornerRms = std::sqrt(cornerSquares / std::max(corners, 1));
    return result;
}

} // namespace carina
