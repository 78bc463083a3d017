#pragma once

#include "engine/core/result.h"
#include "engine/sync/actions/event_table.h"
#include "engine/sync/strategies/action_meter.h"
#include "engine/sync/strategies/application_analysis.h"
#include "engine/sync/strategies/relayed_view.h"

#include <map>

namespace carina
{

/// Who may act on a shared object.
struct Ownership {
    ParticipantId owner;
    std::uint16_t epoch = 0; ///< incremented with each change of owner; wraps
    /// Of an object that is lifted out of its place: the last epoch in which it was there. Actions
    /// until then are void.
    std::optional<std::uint16_t> inPlace{};

    friend bool operator==(const Ownership&, const Ownership&) = default;
};

/// An action on a shared object, from now until the next action; a rate of 0 stops the object.
struct ObjectAction {
    ActionKind kind = ActionKind::Rotation;
    Vec3 axis_A = Vec3::UnitX(); ///< of length 1 to kAxisTolerance
    double rate = 0.0;           ///< rad/s, m/s or 1/s by kind, at most kFastestAction
    ActedPose from{};            ///< start pose where nobody has acted on the object yet
    bool anew = false;           ///< start at `from` in any case: moves the object there
};

/// The shared objects that are acted on, at one node: the ownership of each, and the action in
/// force. A value: it is copied to the threads that draw.
class SharedActions
{
public:
    static constexpr double kAxisTolerance = 1e-6;
    /// Range of the scale at which objects are drawn and actions begin.
    static constexpr double kSmallestScale = 1e-3;
    static constexpr double kLargestScale = 1e3;

    void setSelf(ParticipantId self)
    {
        ++m_revision;
        m_self = self;
    }
    [[nodiscard]] ParticipantId self() const { return m_self; }
    void clear();

    /// Sets the ownership of an object, taken from the facts, and forgets an action that is void by
    /// it. @returns whether it changed.
    bool share(ObjectId object, const Ownership& ownership);
    /// Nothing for an object that is not shared.
    [[nodiscard]] std::optional<ParticipantId> ownerOf(ObjectId object) const;
    /// Whether `who` is the present owner of the action's object, under the epoch of the action.
    [[nodiscard]] bool isOwners(ParticipantId who, const EventCpo& event) const;
    /// Whether this node owns the object.
    [[nodiscard]] bool isOwn(ObjectId object) const;

    /// An action of this node that starts at session time t, or with the newest on the object if
    /// that starts later, by at most kLongestLocalLag: from the pose of the object then, with the
    /// next action counter.
    ///
    /// @param drawn local time at which a relayed strategy is asked for that pose
    /// @returns NotPermitted for an object that this node does not own; NotFinite; OutOfRange for
    ///          an axis that is not of unit length and a rate beyond kFastestAction.
    [[nodiscard]] Result<EventCpo> begun(ObjectId object, const ObjectAction& action, SessionTime t,
                                         LocalTime drawn) const;
    /// An action as it continues under the present ownership: unchanged where it was taken under
    /// it, else with the new epoch and the counter 0. Later actions of the previous owner that
    /// never arrived are thereby void everywhere. Nothing for an object that is not shared, and for
    /// an action from before the object was put back.
    [[nodiscard]] std::optional<EventCpo> continued(EventCpo event) const;

    /// As EventTable::take; refuses what is void.
    EventTable::Verdict take(const EventCpo& event, std::optional<SessionTime> session,
                             LocalTime now);
    void forget(ObjectId object);
    /// What a relayed strategy shows, in place of the actions here; nullptr: nothing.
    void show(const RelayedView* view);
    /// Changes whenever the result of shown() may change.
    [[nodiscard]] std::uint64_t revision() const { return m_revision; }
    [[nodiscard]] const EventTable& table() const { return m_table; }

    /// The object at session time t, which is local time `drawn`, as far as is known at local time
    /// `now`. Nothing before the first action on it.
    [[nodiscard]] std::optional<ShownObject> shown(ObjectId object, SessionTime t, LocalTime drawn,
                                                   LocalTime now) const;
    /// For every object on which more than one action arrived.
    [[nodiscard]] const std::map<ObjectId, ActionMeter>& meters() const { return m_meters; }
    /// How often each participant acts on the objects.
    [[nodiscard]] const ApplicationAnalysis& analysis() const { return m_analysis; }

private:
    /// Whether an action is from before its object was put back into its place.
    [[nodiscard]] bool isVoid(const EventCpo& event) const;

    std::uint64_t m_revision = 0;
    ParticipantId m_self = kNobody;
    EventTable m_table;
    std::optional<RelayedView> m_relayed;
    std::map<ObjectId, ActionMeter> m_meters;
    ApplicationAnalysis m_analysis;
    std::unordered_map<ObjectId, Ownership> m_owners;
};

} // namespace carina
