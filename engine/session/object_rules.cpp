#include "engine/session/object_rules.h"

#include "engine/session/facts/plain_name.h"
#include "engine/session/participant_limits.h"

#include <algorithm>
#include <string>

namespace carina
{
namespace
{

constexpr ParticipantId kHostOfObjects{0};

struct ObjectCount {
    std::size_t all = 0;
    std::size_t ofKind = 0;
};

template <class Counts>
ObjectCount countObjects(const SessionState& state, ObjectKind kind, const Counts& counts)
{
    ObjectCount count;
    for (const auto& [id, object] : state.objects())
        if (counts(object)) {
            ++count.all;
            count.ofKind += object.kind == kind ? 1 : 0;
        }
    return count;
}

Result<void> checkRoom(const Participant& who, const ObjectCount& count)
{
    const bool isFull = count.all >= mostObjectsOf(who.role)
                        || (who.role == Role::Trainee && count.ofKind >= kMostOfAKind);
    return isFull ? fail(Errc::NotPermitted, "no more objects of this kind") : Result<void>{};
}

} // namespace

Result<void> checkShared(const SessionState& state, const FactBody& body)
{
    const auto* shared = std::get_if<fact::ObjectShared>(&body);
    if (shared == nullptr || shared->owner == kHostOfObjects
        || state.objects().contains(shared->object))
        return {};
    const auto owner = state.participants().find(shared->owner);
    if (owner == state.participants().end())
        return {}; // refused by who may share what
    return checkRoom(owner->second,
                     countObjects(state, shared->kind,
                                  [&](const SharedObject& o) { return o.sharer == shared->owner; }))
        .and_then([shared] { return checkName(shared->name); });
}

Result<void> checkHandOver(const SessionState& state, const fact::ObjectHandedOver& handed)
{
    const auto known = state.objects().find(handed.object);
    if (known == state.objects().end())
        return fail(Errc::OutOfRange, "object " + std::to_string(handed.object.value));
    const SharedObject& object = known->second;
    const auto heir = state.participants().find(handed.owner);
    if (heir == state.participants().end())
        return fail(Errc::OutOfRange, "participant " + std::to_string(handed.owner.value));
    const Participant& owner = heir->second;
    const bool isElsewhere = owner.role == Role::Trainee && owner.station != object.station;
    if (owner.role == Role::Observer || isElsewhere)
        return fail(Errc::NotPermitted, owner.name);
    if (object.epoch != handed.epoch)
        return fail(Errc::OwnerChanged, object.name);
    return checkRoom(owner, countObjects(state, object.kind, [&](const SharedObject& other) {
                         return other.owner == owner.id && other.id != object.id;
                     }));
}

bool mayHandOver(const SessionState& state, const Participant& author,
                 const fact::ObjectHandedOver& handed)
{
    const SharedObject& object = state.objects().at(handed.object);
    const Participant& heir = state.participants().at(handed.owner);
    return object.owner == author.id
           && (heir.role == Role::Instructor || heir.id == author.id
               || std::ranges::find(object.wantedBy, heir.id) != object.wantedBy.end());
}

} // namespace carina
