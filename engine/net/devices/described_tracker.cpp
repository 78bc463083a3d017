#include "engine/net/devices/described_tracker.h"

#include "engine/net/devices/device_tracker.h"
#include "engine/vision/camera_tracker.h"

namespace carina
{
namespace
{

/// @pre it is of a camera, with the markers of each tool.
CameraTrackerSettings cameraSettings(const TrackerDescription& description)
{
    CameraTrackerSettings settings{.place = {.kind = kindOfPlace(description.address),
                                             .path = description.address,
                                             .rate = double(description.rate_hz)},
                                   .camera = description.camera,
                                   .playing =
                                       description.isLooped ? Playing::Looped : Playing::Once};
    for (const DescribedTool& tool : description.tools) {
        settings.dictionary = tool.body->dictionary;
        settings.tools.push_back({tool.name, tool.role, tool.body->markers});
    }
    return settings;
}

} // namespace

Result<std::unique_ptr<Tracker>> describedTracker(const TrackerDescription& description,
                                                  ReadSessionClock clock,
                                                  std::unique_ptr<DeviceLog> log)
{
    const auto asTracker = [](auto made) -> std::unique_ptr<Tracker> { return made; };
    if (description.kind == TrackerKind::Camera)
        return CameraTracker::make(cameraSettings(description), std::move(clock)).map(asTracker);
    return DeviceTracker::make(description, std::move(clock), std::move(log)).map(asTracker);
}

} // namespace carina
