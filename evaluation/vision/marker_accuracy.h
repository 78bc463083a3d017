#pragma once

#include "engine/core/units.h"
#include "engine/vision/marker_watch.h"
#include "evaluation/vision/marker_renderer.h"

namespace carina
{

/// How one body is seen at one distance, at poses drawn at random.
struct MarkerAccuracy {
    double distance = 0.0; ///< metres
    int poses = 0;         ///< that were rendered
    int seen = 0;          ///< with a pose that is given
    int ambiguous = 0;     ///< of which two poses fit
    int wrong = 0;         ///< of those given, off by more than 10 degrees
    // Of those given that are not wrong:
    double acrossRms = 0.0;   ///< of the position, along each axis across the line of sight, metres
    double alongRms = 0.0;    ///< along it, metres
    double rotationRms = 0.0; ///< radians
    double reprojectionRms = 0.0; ///< pixels
    /// Mean over poses of e^T C^-1 e / 6, where C is the covariance that the tracker stated and e
    /// the error: 1 where the covariance is right.
    double normalisedSquare = 0.0;
    /// RMS of the corners' errors against their true projections, along each axis, pixels.
    double cornerRms = 0.0;
};

/// Sums up how a body was seen, against where it was.
class AccuracySum
{
public:
    void add(const BodySight& sight, const RigidTransform& X_TB);
    /// What was added; without the error of the corners. @param distance of the body, metres
    [[nodiscard]] MarkerAccuracy result(double distance) const;

private:
    MarkerAccuracy m_sum; ///< with squares where the result has their root
};

struct AccuracyTrial {
    CameraModel camera;
    MarkerDictionary dictionary = MarkerDictionary::Bits4Of50;
    MarkerBody body;
    Rendering rendering;
    double distance = 0.5;      ///< from the camera to the body's origin, metres
    Angle tilt = degrees(50.0); ///< most, of the body's +z against the line to the camera
    bool isTurning = false;     ///< a sleeve: any angle about +z, which is across the line of sight
    int poses = 100;
    std::uint32_t seed = 1;
};

/// Renders the body at poses drawn at random, at one distance and within the middle two thirds of
/// the picture, each looked at by a watch that knows nothing of the others.
/// @pre the camera is usable, and the body passes checkBody.
[[nodiscard]] MarkerAccuracy markerAccuracy(const AccuracyTrial& trial);

} // namespace carina
