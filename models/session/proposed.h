#pragma once

#include "engine/net/node/session_node.h"

#include <algorithm>
#include <variant>

namespace carina
{

/// Whether this program proposed such a fact that is not decided yet.
/// @param isMeant (Body): whether it is one of those that are asked about
template <class Body, class IsMeant>
[[nodiscard]] bool isProposed(const SessionNode& node, const IsMeant& isMeant)
{
    return std::ranges::any_of(node.pending(), [&isMeant](const FactBody& body) {
        const auto* proposed = std::get_if<Body>(&body);
        return proposed && isMeant(*proposed);
    });
}

} // namespace carina
