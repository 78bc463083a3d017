#include "engine/io/site/devices/printed_tracker.h"

#include "engine/io/site/devices/camera_file.h"
#include "engine/vision/printed_tools.h"

namespace carina
{
namespace
{

CameraModel usualWebcam()
{
    return {.width = 1280, .height = 720, .focal = {1065.0, 1065.0}, .centre = {639.5, 359.5}};
}

} // namespace

TrackerDescription printedTracker(const std::string& address)
{
    TrackerDescription described{
        .address = address, .kind = TrackerKind::Camera, .rate_hz = 30, .camera = usualWebcam()};
    for (const PrintedTool& tool : printedTools())
        described.tools.push_back({.name = tool.name,
                                   .role = tool.role,
                                   .body = MarkedBody{kPrintedDictionary, tool.body}});
    return described;
}

Result<void> takeCalibration(TrackerDescription& described, const std::filesystem::path& file)
{
    return readCameraFile(file).map([&](const CalibratedCamera& camera) {
        described.camera = camera.model;
        described.calibration = file.string();
    });
}

} // namespace carina
