#include "engine/net/devices/described_tracker.h"

#include "engine/net/devices/igtl_tracker.h"
#include "engine/net/devices/ndi_tracker.h"
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
                                                  ReadSessionClock clock)
{
    const auto asTracker = [](auto made) -> std::unique_ptr<Tracker> { return made; };
    if (description.kind == TrackerKind::Camera)
        return CameraTracker::make(cameraSettings(description), std::move(clock)).map(asTracker);
    if (description.kind == TrackerKind::OpenIgtLink)
        return IgtlTracker::make(description, std::move(clock)).map(asTracker);
    return NdiTracker::make(description, std::move(clock)).map(asTracker);
}

} // namespace carina
