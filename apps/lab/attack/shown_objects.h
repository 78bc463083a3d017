#pragma once

#include "engine/net/node/session_node.h"

#include <map>
#include <optional>

namespace carina::lab
{

/// Where a node shows the objects that are moved by actions, at a time when nobody moves them.
class ShownObjects
{
public:
    /// Of all objects that there are.
    explicit ShownObjects(const SessionNode& node);

    /// How many of them the node shows elsewhere now, or shows moved that nobody had moved.
    [[nodiscard]] std::int64_t moved(const SessionNode& node) const;

private:
    [[nodiscard]] static std::optional<ActedPose> shownBy(const SessionNode& node, ObjectId object);

    std::map<ObjectId, std::optional<ActedPose>> m_before;
};

} // namespace carina::lab
