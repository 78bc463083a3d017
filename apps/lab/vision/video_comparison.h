#pragma once

#include "engine/vision/marker_watch.h"
#include "evaluation/vision/marker_accuracy.h"

#include <filesystem>
#include <functional>

namespace carina::lab
{

/// X_TB of a body in the picture of a video taken at this time since the first; nothing where it is
/// not before the camera.
using BodyTruth = std::function<std::optional<RigidTransform>(std::size_t body, Duration t)>;

/// How a body of a video was found at about one distance.
struct BodyInVideo {
    std::size_t body = 0;
    MarkerAccuracy accuracy{}; ///< its distance is that to the nearest decimetre
};

/// Follows the bodies through a video, as the camera tracker does, and compares with where they
/// were, wherever their origin is in the picture: for each body by its distance.
/// @returns the errors of PictureSource::open
[[nodiscard]] Result<std::vector<BodyInVideo>> compareVideo(const std::filesystem::path& video,
                                                            const WatchedBodies& watched,
                                                            const BodyTruth& truth);

} // namespace carina::lab
