#include "engine/tracking/markers/probe.h"

#include "engine/geometry/fit/fit_covariance.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace carina
{
namespace
{

/// Lets the covariance of markers without any noise be inverted, and is far below any tracker's.
constexpr double kLeastVariance = 1e-18; // m^2

} // namespace

Mat3 markerCovariance(const MarkerNoise& noise, const Vec3& sight)
{
    const double ratio = noise.depthRatio;
    const double across = noise.rms.si * noise.rms.si / (2.0 + ratio * ratio);
    return across * (Mat3::Identity() + (ratio * ratio - 1.0) * (sight * sight.transpose()));
}

bool faces(const ToolMarker& marker, const Vec3& d_O, Angle largestAngle)
{
    const double length = marker.normal_O.norm();
    return length == 0.0 || marker.normal_O.dot(d_O) >= length * std::cos(largestAngle.si);
}

std::vector<std::size_t> facingMarkers(const Probe& probe, const Vec3& d_O)
{
    std::vector<std::size_t> facing;
    for (std::size_t i = 0; i < probe.markers.size(); ++i)
        if (faces(probe.markers[i], d_O, probe.largestAngle))
            facing.push_back(i);
    return facing;
}

Angle PoseError::rotation() const
{
    return radians(
        std::sqrt(covariance_F.topLeftCorner<3, 3>().trace() + bias_F.head<3>().squaredNorm()));
}

Length PoseError::at(const Vec3& p_FQ) const
{
    return metres(std::sqrt(pointCovariance(covariance_F, p_FQ).trace()
                            + pointShift(bias_F, p_FQ).squaredNorm()));
}

Result<PoseError> poseError(const Probe& probe, std::span<const std::size_t> seen, const Vec3& d_O,
                            const MarkerNoise& noise)
{
    const Mat3 covariance = markerCovariance(noise, d_O) + kLeastVariance * Mat3::Identity();
    std::vector<LandmarkError> landmarks;
    std::vector<Vec3> biases;
    for (const std::size_t i : seen) {
        landmarks.push_back({probe.markers[i].p_OQ, covariance});
        biases.push_back(noise.outward.si * probe.markers[i].normal_O.stableNormalized());
    }
    const Result<Mat6> spread = fitCovariance(landmarks);
    if (!spread)
        return tl::unexpected(spread.error());
    PoseError error{.covariance_F = *spread, .markers = seen.size()};
    if (noise.outward.si != 0.0)
        error.bias_F = *fitBias(landmarks, biases);
    return error;
}

Result<PoseError> poseError(const Probe& probe, const Vec3& d_O, const MarkerNoise& noise)
{
    const std::vector<std::size_t> seen = facingMarkers(probe, d_O);
    if (seen.size() < probe.fewest)
        return fail(Errc::TooFewLandmarks, std::to_string(seen.size()) + " markers are seen");
    return poseError(probe, seen, d_O, noise);
}

ProbeSurvey surveyProbe(const Probe& probe, const MarkerNoise& noise, const Vec3& p_OQ,
                        int directions)
{
    ProbeSurvey survey;
    survey.share.assign(probe.markers.size() + 1, 0.0);
    survey.fewest = probe.markers.size();
    double turns = 0.0;
    double ways = 0.0;
    int posed = 0;
    for (const Vec3& d_O : directionsAllRound(directions)) {
        const std::vector<std::size_t> seen = facingMarkers(probe, d_O);
        survey.fewest = std::min(survey.fewest, seen.size());
        for (std::size_t k = 0; k <= seen.size(); ++k)
            survey.share[k] += 1.0 / directions;
        if (seen.size() < probe.fewest)
            continue;
        const auto error = poseError(probe, seen, d_O, noise);
        if (!error)
            continue;
        turns += std::pow(error->rotation().si, 2);
        ways += std::pow(error->at(p_OQ).si, 2);
        ++posed;
    }
    survey.posed = double(posed) / directions;
    survey.rotation = radians(std::sqrt(turns / std::max(1, posed)));
    survey.position = metres(std::sqrt(ways / std::max(1, posed)));
    return survey;
}

std::vector<Vec3> directionsAllRound(int count)
{
    const double golden = std::numbers::pi * (3.0 - std::sqrt(5.0));
    std::vector<Vec3> directions;
    for (int i = 0; i < count; ++i) {
        const double z = 1.0 - (2.0 * i + 1.0) / count;
        const double across = std::sqrt(1.0 - z * z);
        directions.emplace_back(across * std::cos(golden * i), across * std::sin(golden * i), z);
    }
    return directions;
}

} // namespace carina
