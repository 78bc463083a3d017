#pragma once

#include "engine/net/session_node.h"

#include <optional>

namespace carina::viewer
{

/// Lets a person choose a session that is found, or type its address; nothing when they leave.
/// @param settings what is known already
[[nodiscard]] std::optional<JoinSettings> askHowToJoin(JoinSettings settings);

} // namespace carina::viewer
