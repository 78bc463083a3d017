#pragma once

#include "engine/session/session_state.h"
#include "engine/tracking/tracker.h"

#include <optional>

namespace carina
{

/// The tool of a tracker whose pose an object has; nothing for what is not tracked.
[[nodiscard]] std::optional<ToolRole> trackedBy(ObjectKind kind);

} // namespace carina
