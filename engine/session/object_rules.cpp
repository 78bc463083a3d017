#include "engine/session/object_rules.h"

#include "engine/anatomy/organ_group.h"
#include "engine/session/participant_limits.h"

#include <algorithm>
#include <string>

namespace carina
{
namespace
{

constexpr ParticipantId kSharingHost{0};

template <class Wanted> std::size_t countObjects(const SessionState& state, Wanted wanted)
{
    return std::size_t(std::ranges::count_if(
        state.objects(), [&wanted](const auto& entry) { return wanted(entry.second); }));
}

Result<void> checkKnown(const SessionState& state, ObjectId id)
{
    if (!state.objects().contains(id))
        return fail(Errc::OutOfRange, "object " + std::to_string(id.value));
    return {};
}

/// Whether a participant may have an object: an observer none, a trainee those of their station.
Result<void> checkNewOwner(const SessionState& state, const SharedObject& object, ParticipantId id)
{
    const auto owner = state.participants().find(id);
    if (owner == state.participants().end() || (isLiftable(object.kind) && !owner->second.present))
        return fail(Errc::OutOfRange, "participant " + std::to_string(id.value));
    const Participant& person = owner->second;
    const bool isElsewhere = person.role == Role::Trainee && person.station != object.station;
    if (person.role == Role::Observer || isElsewhere)
        return fail(Errc::NotPermitted, person.name);
    const bool holdsMost =
        countObjects(state,
                     [&](const SharedObject& held) {
                         return held.owner == id && held.kind == ObjectKind::OrganGroup;
                     })
        >= kMostGroupsHeld;
    if (person.role == Role::Trainee && object.kind == ObjectKind::OrganGroup && holdsMost)
        return fail(Errc::NotPermitted, person.name);
    return {};
}

Result<void> checkLiftable(const SessionState& state, StationId station,
                           const fact::ObjectShared& shared)
{
    if (shared.kind == ObjectKind::OrganGroup && !groupFromName(shared.name))
        return fail(Errc::OutOfRange, "a group of organs named " + shared.name);
    const std::size_t there = countObjects(state, [station](const SharedObject& object) {
        return object.station == station && isLiftable(object.kind);
    });
    if (there >= kMostLiftables)
        return fail(Errc::NotPermitted, "no more objects to lift out");
    return {};
}

} // namespace

Result<void> checkHandOver(const SessionState& state, const fact::ObjectHandedOver& handed)
{
    if (const auto known = checkKnown(state, handed.object); !known)
        return known;
    const SharedObject& object = state.objects().at(handed.object);
    const bool isPutBack = handed.owner == kNobody && isLiftable(object.kind);
    if (!isPutBack)
        if (const auto may = checkNewOwner(state, object, handed.owner); !may)
            return may;
    if (object.epoch != handed.epoch || (isPutBack && object.owner == kNobody))
        return fail(Errc::OwnerChanged, object.name);
    return {};
}

Result<void> checkWish(const SessionState& state, const fact::ObjectWanted& wanted)
{
    if (const auto known = checkKnown(state, wanted.object); !known)
        return known;
    const SharedObject& object = state.objects().at(wanted.object);
    return object.owner == kNobody ? fail(Errc::OwnerChanged, object.name) : Result<void>{};
}

bool mayPassOn(const SessionState& state, const Participant& trainee,
               const fact::ObjectHandedOver& handed)
{
    const SharedObject& object = state.objects().at(handed.object);
    const bool lifts =
        object.owner == kNobody && handed.owner == trainee.id && object.station == trainee.station;
    return object.owner == trainee.id || lifts;
}

Result<void> checkShared(const SessionState& state, StationId station,
                         const fact::ObjectShared& shared)
{
    if (state.objects().contains(shared.object))
        return {};
    if (isLiftable(shared.kind))
        return checkLiftable(state, station, shared);
    const auto owner = state.participants().find(shared.owner);
    if (shared.owner == kSharingHost || owner == state.participants().end())
        return {}; // one who is not there is refused by who may share what
    const auto ofOwner = [&shared](const SharedObject& object) {
        return object.owner == shared.owner && !isLiftable(object.kind);
    };
    const std::size_t ofKind = countObjects(state, [&](const SharedObject& object) {
        return ofOwner(object) && object.kind == shared.kind;
    });
    const Role role = owner->second.role;
    if (countObjects(state, ofOwner) >= mostObjectsOf(role)
        || (role == Role::Trainee && ofKind >= kMostOfAKind))
        return fail(Errc::NotPermitted, "no more objects of this kind");
    return {};
}

} // namespace carina
