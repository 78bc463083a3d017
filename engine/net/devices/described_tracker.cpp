#include "engine/net/devices/described_tracker.h"

#include "engine/net/devices/device_tracker.h"

namespace carina
{

Result<std::unique_ptr<Tracker>> describedTracker(const TrackerDescription& description,
                                                  ReadSessionClock clock,
                                                  std::unique_ptr<DeviceLog> log)
{
    const auto asTracker = [](auto made) -> std::unique_ptr<Tracker> { return made; };
    return DeviceTracker::make(description, std::move(clock), std::move(log)).map(asTracker);
}

} // namespace carina
