#pragma once

#include "engine/net/node/session_node.h"

namespace carina
{

/// Shares at a station what can be lifted out there, in its place: each group of organs, and a
/// second tube. What is shared already stays as it is, so that a session from before there was
/// such a thing gets the rest.
/// @pre the node hosts the session
void shareLiftables(SessionNode& node, StationId station);

} // namespace carina
