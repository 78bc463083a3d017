#pragma once

#include "engine/core/result.h"
#include "engine/tracking/pose_history.h"

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
    Chest, ///< a marker on the manikin's chest, which rises as it breathes
    Other,
};

/// One tool of a tracker: its name as the device or the site gives it, and its poses X_TO.
struct TrackedTool {
    std::string name;
    ToolRole role = ToolRole::Other;
    PoseHistory* history = nullptr; ///< X_T<tool>; owned by the tracker, lives as long as it
};

/// A device that measures poses of tools in its own frame T and pushes them, stamped with the time
/// of exposure, into one history per tool. Its thread is its own affair.
class Tracker
{
public:
    virtual ~Tracker() = default;

    /// Begins to deliver. @returns TrackerFailed with what to look at.
    [[nodiscard]] virtual Result<void> start() = 0;

    /// Ends delivery; on return no sample arrives any more. Harmless when not started.
    virtual void stop() = 0;

    /// The tools, fixed from construction on.
    [[nodiscard]] virtual std::vector<TrackedTool> tools() const = 0;
};

} // namespace carina
