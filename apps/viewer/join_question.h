#pragma once

#include "engine/net/session_node.h"

#include <QString>

#include <optional>

namespace carina::viewer
{

/// Lets a person choose a session that is found, or type its address; nothing when they leave.
/// @param settings what is known already @param link leads into a session; may be empty
[[nodiscard]] std::optional<JoinSettings> askHowToJoin(JoinSettings settings, const QString& link);

} // namespace carina::viewer
