#pragma once

#include "engine/core/result.h"
#include "engine/geometry/rigid_transform.h"
#include "engine/registration/calibration/tube_rest.h"

#include <span>

namespace carina
{

/// A touch of a tube with the tip of a stylus, in the frame N of the tube's markers.
struct TubeTouch {
    TubePart part = TubePart::Wall;
    Vec3 p_NQ = Vec3::Zero(); ///< metres
};

/// A tube as it was touched.
struct TubeCalibration {
    RigidTransform X_NE; ///< the connector's frame E in that of the markers
    TubeRest rest;
    Length fle;                       ///< RMS error of a touch, estimated from the residuals
    double degrees = 0.0;             ///< degrees of freedom of that estimate
    double rms = 0.0;                 ///< of the touches' distances from its shape, metres
    Mat3 covariance_N = Mat3::Zero(); ///< of the tip in N, m^2, by that estimate

    [[nodiscard]] Vec3 p_NQ_tip() const { return X_NE * tipOfTube(rest); }
};

/// The limits of a tube's calibration.
struct TubeSettings {
    std::size_t fewestWall = 4;
    double shortestPart = 0.5; ///< of the way from rim to tip that the wall is touched
    Length leastSagitta = millimetres(5.0);
    Length largestRms = millimetres(1.0); ///< of the touches' distances from the shape
};

/// Finds connector frame, length and curvature of a tube by least squares over all touches:
///
///     on the rim    its distances from the circle of the connector, across and along the axis
///     on the wall   its distance from the centreline, less the tube's radius
///     at the tip    its distance from the end of the centreline, as three coordinates
///
/// which all have the variance fle^2 / 3 for touches of equal and isotropic error. First with one
/// curvature; with one for each half where that fits better than chance explains one time in a
/// hundred (F test). From the parameters' covariance follows that of the tip.
///
/// @param outerDiameter of the tube
/// @returns TooFewPoints without three touches of the rim, fewestWall of the wall and one of the
///          tip; DegenerateLandmarks where the rim was touched at one side only, the wall along too
///          short a part, or the tube is straight, so that the plane it is bent in is undetermined;
///          NoSurfaceFit where the touches are off by more than largestRms; NotFinite; OutOfRange
///          for a diameter outside 2 to 20 mm or a coordinate of a kilometre. The detail says what
///          is missing.
[[nodiscard]] Result<TubeCalibration> calibrateTube(std::span<const TubeTouch> touches,
                                                    Length outerDiameter,
                                                    const TubeSettings& settings = {});

} // namespace carina
