#pragma once

#include "engine/lungs/breathing_pattern.h"
#include "engine/session/breathing_timeline.h"
#include "engine/session/facts.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace carina
{

struct Participant {
    ParticipantId id;
    Role role = Role::Observer;
    std::string name;
    StationId station;
    bool present = false;
};

struct SharedObject {
    ObjectId id;
    ParticipantId owner;
    StationId station;
    ObjectKind kind = ObjectKind::Tube;
    std::string name;
};

struct Station {
    StationId id;
    std::string name;
    std::string anatomyHash;
    std::string anatomyName;
    BreathingTimeline breathing;
};

/// Everything that follows from the facts so far, at any node. A value: copied to whoever draws.
///
/// Applying the same facts in the order of their numbers gives the same state everywhere; a state
/// asked for a time is a pure function of (facts, time).
class SessionState
{
public:
    /// @pre fact.number is one more than the last applied.
    void apply(const Fact& fact);

    [[nodiscard]] FactNumber lastApplied() const;
    [[nodiscard]] const std::string& name() const;
    [[nodiscard]] const std::string& sessionId() const;
    [[nodiscard]] SessionPhase phaseAt(SessionTime t) const;
    /// Time spent in Running up to t, pauses left out.
    [[nodiscard]] Duration runningTime(SessionTime t) const;

    [[nodiscard]] const std::map<ParticipantId, Participant>& participants() const;
    [[nodiscard]] const std::map<ObjectId, SharedObject>& objects() const;
    [[nodiscard]] const std::map<StationId, Station>& stations() const;
};

} // namespace carina
