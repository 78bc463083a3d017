#pragma once

#include "engine/core/session_time.h"
#include "engine/tracking/pose_sample.h"
#include "engine/vision/body_pose.h"
#include "engine/vision/marker_body.h"
#include "engine/vision/marker_detector.h"

#include <vector>

namespace carina
{

/// How a body was seen in one picture.
struct BodySight {
    int markers = 0;                  ///< of it, seen
    std::optional<FittedBody> pose{}; ///< nothing where none was fitted
    bool isAmbiguous = false;         ///< the pose may be the mirror image of the true one
    double evidence = 0.0;            ///< of the pose against its mirror image; see BodyFit
};

/// What a camera and the bodies before it are.
struct WatchedBodies {
    CameraModel camera;
    MarkerDictionary dictionary = MarkerDictionary::Bits4Of50;
    std::vector<MarkerBody> bodies;
};

/// Follows bodies from picture to picture. No clock, no thread: pictures go in, poses come out.
///
/// A flat body seen small has two poses that fit (BodyFit::rival). The better one is taken where it
/// is kSure times likelier. Otherwise the one is taken that continues the last pose that was sure,
/// while that is not older than kMemory and the other one is clearly farther from it; otherwise the
/// body is ambiguous.
///
/// There is no pose where the corners are farther from it (RMS) than 1.5 pixels and 3 % of the
/// mean side of its markers in the picture together.
class MarkerWatch
{
public:
    static constexpr double kSure = 6.9; ///< ln 1000
    static constexpr Duration kMemory = std::chrono::milliseconds{250};

    /// @pre the camera is usable (isUsable), and each body passes checkBody.
    explicit MarkerWatch(WatchedBodies watched);

    /// @param time of the exposure; only differences of times count
    /// @returns one sight for each body.
    [[nodiscard]] std::vector<BodySight> look(const GreyPicture& picture, Duration time);

    /// The same of markers that were found in a picture.
    [[nodiscard]] std::vector<BodySight> look(const std::vector<DetectedMarker>& seen,
                                              Duration time);

private:
    struct Known {
        RigidTransform X_TB;
        Duration time{};
    };

    [[nodiscard]] BodySight sightOfBody(std::size_t body, const std::vector<DetectedMarker>& seen,
                                        Duration time);

    WatchedBodies m_watched;
    std::vector<std::optional<Known>> m_known; // of each body, the last pose that was sure
};

/// The covariance of a body's pose as a small motion of the points of the body, see Mat6.
[[nodiscard]] Mat6 inBody(const FittedBody& pose);

/// A body's pose as a sample of a tracker, with its covariance: tracked, or partly occluded where
/// its expected error is large, above 1 degree or 3 mm (RMS). std::nullopt where it was not seen,
/// and where it is ambiguous.
/// @param focal of the camera, pixels: the fit error is that of the corners at their distance
[[nodiscard]] std::optional<PoseSample> sampleOf(const BodySight& sight, double focal,
                                                 SessionTime time);

/// The RMS of the rotation and of the body's origin that a covariance expects.
struct ExpectedError {
    double rotation = 0.0; ///< radians
    double position = 0.0; ///< metres
};
[[nodiscard]] ExpectedError expectedError(const FittedBody& pose);

} // namespace carina
