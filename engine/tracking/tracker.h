#pragma once

#include "engine/core/result.h"
#include "engine/tracking/markers/probe.h"
#include "engine/tracking/pose_history.h"
#include "engine/tracking/tool_sight.h"

#include <optional>
#include <string>
#include <vector>

namespace carina
{

/// What a tracked tool is for. Its frame letter follows (H, J, E, S, ... see docs/frames.md).
enum class ToolRole : std::uint8_t {
    Head,
    Jaw,
    Tube,
    Stylus,
    Manikin,
    Chest,        ///< a marker on the manikin's chest, which rises as it breathes
    Hand,         ///< a probe on the back of a hand
    Laryngoscope, ///< a probe on its handle
    Other,
};

/// One tool of a tracker: its name as given by the device or the site, and its poses X_TO.
struct TrackedTool {
    std::string name;
    ToolRole role = ToolRole::Other;
    PoseHistory* history = nullptr; ///< X_T<tool>; owned by the tracker, valid as long as it exists
    std::optional<Probe> probe{};   ///< its markers, where they are known
    MarkerNoise noise{};            ///< with which they are seen
};

/// A device that measures poses of tools in its own frame T and pushes them, with the time of
/// exposure, into one history per tool. Implementations deliver on a thread of their own.
class Tracker
{
public:
    virtual ~Tracker() = default;

    /// Starts delivery. @returns TrackerFailed, with what to check in the detail.
    [[nodiscard]] virtual Result<void> start() = 0;

    /// Stops delivery; after it returns no sample arrives. No effect when not started.
    virtual void stop() = 0;

    /// The tools; they do not change after construction.
    [[nodiscard]] virtual std::vector<TrackedTool> tools() const = 0;

    /// What keeps the device, or one of its tools, from tracking, for the person who can mend it;
    /// empty where nothing does. May be called from any thread.
    [[nodiscard]] virtual std::string trouble() const { return {}; }

    /// When the present playing of a video began, by the clock of its samples; nothing of what is
    /// no video, and before the first picture. May be called from any thread.
    [[nodiscard]] virtual std::optional<SessionTime> playedSince() const { return std::nullopt; }

    /// What the device says now of how it sees a tool, by its index in tools(). May be called from
    /// any thread.
    [[nodiscard]] virtual ToolSight sightOf(std::size_t /*tool*/) const
    {
        return ToolSight::Unsaid;
    }
};

} // namespace carina
