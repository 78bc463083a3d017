#include "engine/tracking/several/tracker_set.h"

#include <utility>

namespace carina
{

TrackerSet::TrackerSet(std::vector<PlacedTracker> devices)
{
    for (PlacedTracker& device : devices) {
        std::size_t number = 0;
        for (TrackedTool& tool : device.tracker->tools()) {
            if (!m_devices.empty())
                tool.history->placeDevice(device.place);
            m_tools.push_back(std::move(tool));
            m_places.push_back({device.tracker.get(), number++});
        }
        m_devices.push_back(std::move(device.tracker));
    }
}

Result<void> TrackerSet::start()
{
    for (const auto& device : m_devices)
        if (auto started = device->start(); !started) {
            stop();
            return started;
        }
    return {};
}

void TrackerSet::stop()
{
    for (const auto& device : m_devices)
        device->stop();
}

std::string TrackerSet::trouble() const
{
    std::string all;
    for (const auto& device : m_devices)
        if (const std::string one = device->trouble(); !one.empty())
            all += (all.empty() ? "" : "; ") + one;
    return all;
}

std::optional<SessionTime> TrackerSet::playedSince() const
{
    for (const auto& device : m_devices)
        if (const auto since = device->playedSince())
            return since;
    return std::nullopt;
}

ToolSight TrackerSet::sightOf(std::size_t tool) const
{
    const Place& place = m_places.at(tool);
    return place.device->sightOf(place.tool);
}

} // namespace carina
