#include "models/tracker/made_tracker.h"

#include "engine/tracking/several/tracker_set.h"

#include <algorithm>
#include <utility>

namespace carina
{

Result<MadeTracker> MadeTracker::make(const TrackerChoice& choice, const ReadSessionClock& clock)
{
    return MadeTracker{}.next(choice, clock);
}

Result<MadeTracker> MadeTracker::next(const TrackerChoice& choice,
                                      const ReadSessionClock& clock) const
{
    MadeTracker made;
    const auto add = [&](const TrackerChoice& of, QByteArray content) {
        return makeTracker(of, clock).map([&](std::unique_ptr<Tracker> tracker) {
            made.m_devices.push_back({std::move(content), std::move(tracker)});
        });
    };
    std::vector<DevicePlace> places;
    for (const auto& [described, place] : devicesOf(choice)) {
        QByteArray content = contentOf(described);
        places.push_back(place);
        if (const Device* before = alike(content, made.m_devices.empty()))
            made.m_devices.push_back({std::move(content), before->tracker, true});
        else if (auto device = add({described, choice.conversation}, std::move(content)); !device)
            return tl::unexpected(device.error());
    }
    if (places.empty()) // a recording
        if (auto played = add(choice, {}); !played)
            return tl::unexpected(played.error());
    if (made.m_devices.size() == 1) {
        made.m_tracker = made.m_devices.front().tracker;
        return made;
    }
    std::vector<PlacedTracker> placed;
    for (std::size_t i = 0; i < places.size(); ++i)
        placed.push_back({made.m_devices[i].tracker, places[i]});
    made.m_tracker = std::make_shared<TrackerSet>(std::move(placed));
    return made;
}

/// The device with this description, first or not as it was.
const MadeTracker::Device* MadeTracker::alike(const QByteArray& content, bool isFirst) const
{
    const auto found = std::ranges::find(m_devices, content, &Device::content);
    const bool isThere = found != m_devices.end() && !content.isEmpty();
    return isThere && isFirst == (found == m_devices.begin()) ? &*found : nullptr;
}

Result<void> MadeTracker::start() const
{
    for (const Device& device : m_devices)
        if (auto started = device.tracker->start(); !started) {
            for (const Device& other : m_devices)
                if (!other.isTakenOver)
                    other.tracker->stop();
            return started;
        }
    return {};
}

void MadeTracker::stopBeside(const MadeTracker& other) const
{
    for (const Device& device : m_devices)
        if (!other.has(*device.tracker))
            device.tracker->stop();
}

bool MadeTracker::has(const Tracker& tracker) const
{
    return std::ranges::any_of(
        m_devices, [&tracker](const Device& device) { return device.tracker.get() == &tracker; });
}

bool MadeTracker::hasFrameOf(const MadeTracker& other) const
{
    return !m_devices.empty() && other.has(*m_devices.front().tracker);
}

} // namespace carina
