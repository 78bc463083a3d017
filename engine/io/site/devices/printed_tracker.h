#pragma once

#include "engine/io/site/devices/tracker_file.h"

namespace carina
{

/// A camera before the tools that are printed (printedTools), each with the markers that its sheet
/// or sleeve has. Until it is calibrated it is taken for a usual webcam: a view of 62 degrees in
/// pictures of 1280 by 720 pixels, without distortion.
/// @param address of a webcam, a video or a folder of pictures (TrackerDescription)
[[nodiscard]] TrackerDescription printedTracker(const std::string& address);

/// Has the camera of a description be the one that a file describes.
/// @returns the errors of readCameraFile.
[[nodiscard]] Result<void> takeCalibration(TrackerDescription& described,
                                           const std::filesystem::path& file);

} // namespace carina
