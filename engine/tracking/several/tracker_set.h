#pragma once

#include "engine/tracking/tracker.h"

#include <memory>

namespace carina
{

/// A device of several that track together, and how it stands to the first.
struct PlacedTracker {
    /// Shared with the set that goes on with it where other devices of a site are replaced.
    std::shared_ptr<Tracker> tracker;
    DevicePlace place{}; ///< X_TD, and how late it stamps
};

/// Several devices as one tracker: its tools are those of all, in the order of the devices, with
/// their poses in the frame T of the first and their stamps on its clock. Each device delivers on
/// its own thread, and goes on where another has trouble.
///
/// A device may be running already, and runs on when the set ends while somebody else has it, too.
class TrackerSet : public Tracker
{
public:
    /// @pre the first was never placed to another device; its place here says nothing.
    explicit TrackerSet(std::vector<PlacedTracker> devices);

    /// @returns the error of the first device that does not start; none runs then.
    [[nodiscard]] Result<void> start() override;
    void stop() override;
    [[nodiscard]] std::vector<TrackedTool> tools() const override { return m_tools; }
    /// That of each device that has any, one after another.
    [[nodiscard]] std::string trouble() const override;
    /// Of the first that plays a video.
    [[nodiscard]] std::optional<SessionTime> playedSince() const override;
    [[nodiscard]] ToolSight sightOf(std::size_t tool) const override;

private:
    /// Where a tool of all is found.
    struct Place {
        const Tracker* device = nullptr;
        std::size_t tool = 0; ///< of that device
    };

    std::vector<std::shared_ptr<Tracker>> m_devices;
    std::vector<TrackedTool> m_tools;
    std::vector<Place> m_places; ///< one for each of m_tools
};

} // namespace carina
