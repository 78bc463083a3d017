#include "models/objects/liftables.h"

#include "engine/anatomy/organ_group.h"

#include <algorithm>

namespace carina
{
namespace
{

constexpr const char* kTubeName = "second tube";

void shareOnce(SessionNode& node, StationId station, ObjectKind kind, const char* name)
{
    const auto state = node.state();
    const bool isShared = std::ranges::any_of(state->objects(), [&](const auto& entry) {
        const SharedObject& object = entry.second;
        return object.station == station && object.kind == kind && object.name == name;
    });
    if (!isShared)
        node.propose(station, fact::ObjectShared{{}, kNobody, kind, name});
}

} // namespace

void shareLiftables(SessionNode& node, StationId station)
{
    for (const OrganGroup group : kOrganGroups)
        shareOnce(node, station, ObjectKind::OrganGroup, groupName(group));
    shareOnce(node, station, ObjectKind::SpareTube, kTubeName);
}

} // namespace carina
