#include "models/station/lifted_objects.h"

namespace carina
{

std::vector<LiftedObject> liftedObjects(const SessionNode& node, StationId station, SessionTime t)
{
    const auto state = node.state();
    std::vector<LiftedObject> lifted;
    for (const auto& [id, object] : state->objects()) {
        if (object.station != station || !isLiftable(object.kind) || object.owner == kNobody)
            continue;
        const auto owner = state->participants().find(object.owner);
        const auto shown = node.shown(id, t);
        lifted.push_back(
            {.object = id,
             .owner = object.owner,
             .ownerName = owner == state->participants().end() ? std::string{} : owner->second.name,
             .isOwn = object.owner == node.self(),
             .acted = shown ? shown->acted : ActedPose{}});
        if (object.kind == ObjectKind::OrganGroup)
            lifted.back().group = groupFromName(object.name);
    }
    return lifted;
}

} // namespace carina
