#pragma once

#include "engine/anatomy/organ_group.h"
#include "engine/net/node/session_node.h"

#include <optional>
#include <string>
#include <vector>

namespace carina
{

/// Something that is lifted out of its place at a station.
struct LiftedObject {
    ObjectId object;
    ParticipantId owner;
    std::string ownerName;
    bool isOwn = false;                ///< of this program's participant
    std::optional<OrganGroup> group{}; ///< std::nullopt: the second tube
    ActedPose acted{};                 ///< its motion from its place
};

/// What is lifted out at a station, at a session time, by object.
[[nodiscard]] std::vector<LiftedObject> liftedObjects(const SessionNode& node, StationId station,
                                                      SessionTime t);

} // namespace carina
