#include "engine/sync/actions/shared_actions.h"

#include "engine/sync/strategies/strategy_choice.h"
#include "engine/sync/wire/sequence.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace carina
{
namespace
{

constexpr std::uint32_t kContinued = 0; // the number of an action that goes on for a new owner

Result<void> checkAction(const ObjectAction& action)
{
    const bool isFinite = std::isfinite(action.rate) && action.axis_A.allFinite()
                          && action.from.X_AO.translation().allFinite()
                          && std::isfinite(action.from.scale);
    if (!isFinite)
        return fail(Errc::NotFinite, "an action");
    if (std::abs(action.axis_A.norm() - 1.0) > SharedActions::kAxisTolerance)
        return fail(Errc::OutOfRange, "the axis of an action");
    if (std::abs(action.rate) > kFastestAction)
        return fail(Errc::OutOfRange, "the rate of an action");
    return {};
}

/// With the size and the place that can be drawn and sent.
ActedPose withinRange(const ActedPose& acted)
{
    const Vec3 p = acted.X_AO.translation().cwiseMax(-kFarthestAction).cwiseMin(kFarthestAction);
    return {RigidTransform{acted.X_AO.rotation(), p},
            std::clamp(acted.scale, SharedActions::kSmallestScale, SharedActions::kLargestScale)};
}

} // namespace

void SharedActions::clear()
{
    SharedActions empty;
    empty.m_revision = m_revision + 1;
    *this = std::move(empty);
}

void SharedActions::forget(ObjectId object)
{
    ++m_revision;
    m_table.forget(object);
    m_meters.erase(object);
}

bool SharedActions::share(ObjectId object, const Ownership& ownership)
{
    ++m_revision;
    const auto [place, isNew] = m_owners.try_emplace(object, ownership);
    const bool changed = isNew || std::exchange(place->second, ownership) != ownership;
    if (const EventCpo* newest = m_table.newest(object); newest && isVoid(*newest))
        forget(object);
    return changed;
}

bool SharedActions::isVoid(const EventCpo& event) const
{
    const auto found = m_owners.find(event.object);
    return found != m_owners.end() && found->second.inPlace
           && !isAfter(event.epoch, *found->second.inPlace);
}

std::optional<ParticipantId> SharedActions::ownerOf(ObjectId object) const
{
    const auto found = m_owners.find(object);
    return found == m_owners.end() ? std::nullopt : std::optional{found->second.owner};
}

bool SharedActions::isOwners(ParticipantId who, const EventCpo& event) const
{
    const auto found = m_owners.find(event.object);
    return found != m_owners.end() && found->second.owner == who
           && found->second.epoch == event.epoch;
}

bool SharedActions::isOwn(ObjectId object) const
{
    return m_self != kNobody && ownerOf(object) == m_self;
}

Result<EventCpo> SharedActions::begun(ObjectId object, const ObjectAction& action, SessionTime t,
                                      LocalTime drawn) const
{
    if (!isOwn(object))
        return fail(Errc::NotPermitted, "object " + std::to_string(object.value));
    if (const auto valid = checkAction(action); !valid)
        return tl::unexpected(valid.error());
    const EventCpo* last = m_table.newest(object);
    const SessionTime start = last ? std::max(t, std::min(last->start, t + kLongestLocalLag)) : t;
    const auto relayed = m_relayed ? m_relayed->at(object, drawn) : std::nullopt;
    const ActedPose from =
        last && !action.anew ? relayed.value_or(evaluate(*last, start)) : action.from;
    EventCpo event;
    event.object = object;
    event.epoch = m_owners.at(object).epoch;
    event.action = last && last->epoch == event.epoch ? last->action + 1 : 1;
    event.kind = action.kind;
    event.axis_A = action.axis_A.cast<float>();
    event.rate = static_cast<float>(action.rate);
    return begunFrom(withinRange(from), start, event);
}

std::optional<EventCpo> SharedActions::continued(EventCpo event) const
{
    const auto found = m_owners.find(event.object);
    if (found == m_owners.end() || isVoid(event))
        return std::nullopt;
    if (std::exchange(event.epoch, found->second.epoch) != found->second.epoch)
        event.action = kContinued;
    return event;
}

EventTable::Verdict SharedActions::take(const EventCpo& event, std::optional<SessionTime> session,
                                        LocalTime now)
{
    if (isVoid(event))
        return EventTable::Verdict::Refused;
    ++m_revision;
    const EventCpo* last = m_table.newest(event.object);
    const std::optional<EventCpo> before = last ? std::optional{*last} : std::nullopt;
    const auto verdict = m_table.take(event, session, now);
    const bool isNew = verdict == EventTable::Verdict::New;
    const auto owner = m_owners.find(event.object);
    const bool isOfOwner = owner != m_owners.end() && owner->second.epoch == event.epoch;
    if (!isNew || event.action == kContinued)
        return verdict;
    if (isOfOwner)
        m_analysis.acted(owner->second.owner, event.object, event.start);
    if (before && session)
        m_meters[event.object].arrived(event, *before, *session);
    return verdict;
}

void SharedActions::show(const RelayedView* view)
{
    const bool isShown =
        view ? m_relayed && m_relayed->revision() == view->revision() : !m_relayed.has_value();
    if (isShown)
        return;
    ++m_revision;
    m_relayed = view ? std::optional{*view} : std::nullopt;
}

std::optional<ShownObject> SharedActions::shown(ObjectId object, SessionTime t, LocalTime drawn,
                                                LocalTime now) const
{
    const EventCpo* event = m_table.inForce(object, t);
    if (!event)
        return std::nullopt;
    const auto relayed = m_relayed ? m_relayed->at(object, drawn) : std::nullopt;
    return ShownObject{withinRange(relayed.value_or(evaluate(*event, t))),
                       !isOwn(object) && m_table.isStale(object, now), event->kind,
                       event->axis_A.cast<double>(), double{event->rate}};
}

} // namespace carina
