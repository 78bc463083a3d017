#include "engine/net/devices/described_tracker.h"

#include "engine/net/devices/igtl_tracker.h"
#include "engine/net/devices/ndi_tracker.h"

namespace carina
{

Result<std::unique_ptr<Tracker>> describedTracker(const TrackerDescription& description,
                                                  ReadSessionClock clock)
{
    const auto asTracker = [](auto made) -> std::unique_ptr<Tracker> { return made; };
    if (description.kind == TrackerKind::OpenIgtLink)
        return IgtlTracker::make(description, std::move(clock)).map(asTracker);
    return NdiTracker::make(description, std::move(clock)).map(asTracker);
}

} // namespace carina
