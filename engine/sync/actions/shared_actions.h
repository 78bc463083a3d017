#pragma once

#include "engine/core/result.h"
#include "engine/sync/actions/event_table.h"
#include "engine/sync/strategies/action_meter.h"
#include "engine/sync/strategies/application_analysis.h"

#include <map>

namespace carina
{

/// Who may act on a shared object.
struct Ownership {
    ParticipantId owner;
    std::uint16_t epoch = 0; ///< rises, wrapping, with each change of owner

    friend bool operator==(const Ownership&, const Ownership&) = default;
};

/// What somebody does to a shared object from now on, until the next action; a rate of 0 stops it.
struct ObjectAction {
    ActionKind kind = ActionKind::Rotation;
    Vec3 axis_A = Vec3::UnitX(); ///< of length 1 to kAxisTolerance
    double rate = 0.0;           ///< rad/s, m/s or 1/s by kind, at most kFastestAction
    ActedPose from{};            ///< where the object is, if nobody has acted on it yet
    bool anew = false;           ///< begins there wherever the object is: puts it there
};

/// The shared objects that are acted on, as one node knows them: the owner of each, and the action
/// in force. A value: copied to whoever draws.
class SharedActions
{
public:
    static constexpr double kAxisTolerance = 1e-6;
    static constexpr double kFastestAction = 100.0;
    /// A scaling that goes on for long ends here.
    static constexpr double kSmallestScale = 1e-3;
    static constexpr double kLargestScale = 1e3;

    void setSelf(ParticipantId self)
    {
        ++m_revision;
        m_self = self;
    }
    [[nodiscard]] ParticipantId self() const { return m_self; }
    void clear();

    /// As the facts say. @returns whether it is another ownership than before.
    bool share(ObjectId object, const Ownership& ownership);
    /// Whether an action is one of the object's present owner.
    [[nodiscard]] bool isOwners(ParticipantId who, const EventCpo& event) const;
    [[nodiscard]] bool isOwn(ObjectId object) const;

    /// The action as this node would take it at session time t: from where the object is then,
    /// and counted on.
    ///
    /// @returns NotPermitted for an object that is not this node's; NotFinite; OutOfRange for an
    ///          axis that is no direction and a rate beyond kFastestAction.
    [[nodiscard]] Result<EventCpo> begun(ObjectId object, const ObjectAction& action,
                                         SessionTime t) const;
    /// An action as it goes on under the present ownership: as it is where it was taken under that,
    /// else in the new owner's name and with the counter 0. So whatever the last owner did that
    /// never arrived is void everywhere. Nothing for an object that is not shared.
    [[nodiscard]] std::optional<EventCpo> continued(EventCpo event) const;

    /// See EventTable::take.
    EventTable::Verdict take(const EventCpo& event, std::optional<SessionTime> session,
                             LocalTime now);
    void forget(ObjectId object);
    /// Another number whenever something may be shown otherwise.
    [[nodiscard]] std::uint64_t revision() const { return m_revision; }
    [[nodiscard]] const EventTable& table() const { return m_table; }

    /// The object at session time t, drawn at local time now. Nothing before the first action on
    /// it.
    [[nodiscard]] std::optional<ShownObject> shown(ObjectId object, SessionTime t,
                                                   LocalTime now) const;
    /// Of every object of which more than one action came.
    [[nodiscard]] const std::map<ObjectId, ActionMeter>& meters() const { return m_meters; }
    /// How often each object is acted on, by all participants.
    [[nodiscard]] const ApplicationAnalysis& analysis() const { return m_analysis; }

private:
    std::uint64_t m_revision = 0;
    ParticipantId m_self = kNobody;
    EventTable m_table;
    std::map<ObjectId, ActionMeter> m_meters;
    ApplicationAnalysis m_analysis;
    std::unordered_map<ObjectId, Ownership> m_owners;
};

} // namespace carina
