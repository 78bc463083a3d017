#pragma once

#include "engine/core/result.h"
#include "engine/core/units.h"
#include "engine/geometry/fit/motion_covariance.h"
#include "engine/tracking/markers/tool_marker.h"

#include <span>
#include <vector>

namespace carina
{

/// The markers of a tool O, which a tracker sees one by one, and what it asks of them.
struct Probe {
    std::vector<ToolMarker> markers{};
    Angle largestAngle = degrees(90.0); ///< between a marker's normal and the tracker's direction
    std::size_t fewest = 3;             ///< that a pose needs
    Length largestMisfit = millimetres(2.0); ///< of a marker that a pose is computed from
};

/// The error with which a tracker sees one marker.
struct MarkerNoise {
    Length rms = millimetres(0.1); ///< root mean square length, random
    /// Standard deviation along the line of sight divided by that in each direction across it.
    double depthRatio = 1.0;
    Length outward{}; ///< constant shift of each marker along its normal
};

/// What the data sheets of the Polaris state for a marker anywhere in the volume: 0.35 mm, most of
/// it in depth. Of the same place at one time it is less.
inline constexpr MarkerNoise kPolarisNoise{millimetres(0.35), 3.0};

/// The covariance in some frame of one marker's random error, m^2.
/// @param sight unit: the direction of the line of sight in that frame
[[nodiscard]] Mat3 markerCovariance(const MarkerNoise& noise, const Vec3& sight);

/// Whether a marker faces the tracker.
/// @param d_O unit: the direction from the tool to the tracker
[[nodiscard]] bool faces(const ToolMarker& marker, const Vec3& d_O, Angle largestAngle);

/// The indices of the markers that face the tracker, ascending.
/// @param d_O unit: the direction from the tool to the tracker
[[nodiscard]] std::vector<std::size_t> facingMarkers(const Probe& probe, const Vec3& d_O);

/// The error of a pose as a small motion of the points of F, see Mat6.
struct PoseError {
    Mat6 covariance_F = Mat6::Zero(); ///< of its random part
    Vec6 bias_F = Vec6::Zero();       ///< its constant part
    std::size_t markers = 0;          ///< that the pose is computed from

    /// Root mean square of the whole turn.
    [[nodiscard]] Angle rotation() const;
    /// Root mean square distance of a point fixed to the tool from its place.
    [[nodiscard]] Length at(const Vec3& p_FQ) const;
};

/// The predicted error of the pose of a tool, in O: the errors of its markers propagated to first
/// order through the fit of equal weights by which the pose is computed (fitCovariance, fitBias).
/// @param seen indices of the markers that are seen
/// @param d_O  unit: the direction from the tool to the tracker
/// @returns the errors of fitCovariance.
[[nodiscard]] Result<PoseError> poseError(const Probe& probe, std::span<const std::size_t> seen,
                                          const Vec3& d_O, const MarkerNoise& noise);

/// The same with all markers that face the tracker.
/// @returns TooFewLandmarks also where these are fewer than the probe needs.
[[nodiscard]] Result<PoseError> poseError(const Probe& probe, const Vec3& d_O,
                                          const MarkerNoise& noise);

/// A probe seen from all directions, in the mean over equal parts of the sphere.
struct ProbeSurvey {
    std::vector<double> share; ///< [k]: of the directions in which at least k markers are seen
    Angle rotation;            ///< RMS over the directions in which there is a pose
    Length position;           ///< RMS at the point, over the same
    double posed = 0.0;        ///< share of these directions
    std::size_t fewest = 0;    ///< seen in any direction
};

/// @param p_OQ the point of the tool at which the error counts, metres
[[nodiscard]] ProbeSurvey surveyProbe(const Probe& probe, const MarkerNoise& noise,
                                      const Vec3& p_OQ, int directions = 2000);

/// `count` directions that divide the sphere into equal parts (a Fibonacci lattice).
[[nodiscard]] std::vector<Vec3> directionsAllRound(int count);

} // namespace carina
