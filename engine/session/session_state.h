#pragma once

#include "engine/core/pauses.h"
#include "engine/session/airway/airway_event_timeline.h"
#include "engine/session/airway/head_position_timeline.h"
#include "engine/session/facts/facts.h"
#include "engine/session/parameter_timeline.h"
#include "engine/session/respiration/respiration_timeline.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace carina
{

/// That a participant was removed.
struct Removal {
    ParticipantId by;
    std::string reason; ///< may be empty
    bool banned = false;
    FactNumber at; ///< runs of a program that came in before are out
};

/// That an object was passed on by somebody else than whose it was.
struct Withdrawal {
    ObjectId object;
    ParticipantId by;
    ParticipantId to; ///< kNobody: it was put back
    SessionTime at;

    friend bool operator==(const Withdrawal&, const Withdrawal&) = default;
};

struct Participant {
    ParticipantId id;
    Role role = Role::Observer;
    std::string name;
    StationId station;
    bool present = false;
    bool muted = false;
    /// The last one, until the participant comes in again.
    std::optional<Removal> removal{};
    /// When the token was replaced because a second program came in with it; of this stay.
    std::optional<SessionTime> tokenReplaced{};
    /// As its program states it; of this stay. Nothing for a program without a tracker.
    std::optional<RegistrationStanding> registration{};
    /// When an instructor moved them to their station; of this stay.
    std::optional<SessionTime> moved{};
    /// What was theirs in this stay, the last of each object that they have not got back.
    std::vector<Withdrawal> withdrawn{};
    Angle turn{};                      ///< of the place where others see them (fact::PlaceChosen)
    SessionTime since{};               ///< when they came in last
    std::optional<SessionTime> left{}; ///< when they left, until they come in again
    /// They left because nothing was heard of their program any more; until they come in again or
    /// are removed, or the host is started anew.
    bool fellSilent = false;
};

struct SharedObject {
    ObjectId id;
    ParticipantId owner;
    std::uint16_t epoch = 1; ///< of the ownership: incremented with each change of owner; wraps
    StationId station;
    ObjectKind kind = ObjectKind::Tube;
    std::string name;
    /// Participants that asked for ownership, in the order of asking.
    std::vector<ParticipantId> wantedBy{};
    ParticipantId sharer{}; ///< who shared it first, whoever owns it now
    /// Of what can be lifted out: the last epoch in which it was in its place. Actions until then
    /// are void.
    std::optional<std::uint16_t> inPlace{};
};

/// What is shown to others at a station.
struct ShownLesson {
    ParticipantId by;           ///< an instructor
    ParticipantId to = kNobody; ///< kNobody: everybody at the station
    Lesson lesson;

    friend bool operator==(const ShownLesson&, const ShownLesson&) = default;
};

/// A lesson that nobody ended: its author left, or came in anew.
struct BrokenOffLesson {
    ShownLesson shown;
    SessionTime at; ///< when that was; once its author is back, when they came in

    friend bool operator==(const BrokenOffLesson&, const BrokenOffLesson&) = default;
};

struct Station {
    static constexpr std::size_t kTryEndsKept = 16; ///< a program that stood still knows them
    StationId id;
    std::string name;
    bool closed = false;
    std::string anatomyHash;
    std::string anatomyName;
    RespirationTimeline respiration;
    AirwayEventTimeline airwayEvents;
    HeadPositionTimeline headPosition; ///< as decided, beyond what events let it move, too
    ParticipantId worker = kNobody;    ///< who took up the work last, and may have gone
    std::optional<ShownLesson> lesson{};
    /// The last one that broke off, of an author who is away or came back since and has not gone
    /// again; until something else is shown, or another patient is laid.
    std::optional<BrokenOffLesson> brokenOff{};
    std::vector<SessionTime> tryEnds{}; ///< when persons ended tries: the last kTryEndsKept
};

/// How head and neck of a station's patient lie at a time: as decided, and as far as the events of
/// then let them.
[[nodiscard]] HeadPosition headPositionAt(const Station& station, SessionTime t);

/// Everything that follows from the facts so far, the same at every node. A value: it is copied to
/// the threads that draw.
///
/// Applying the same facts in the order of their numbers gives the same state everywhere; values at
/// a time are pure functions of the facts and the time.
class SessionState
{
public:
    /// Applies a fact. One about an unknown or closed station, or an unknown participant, changes
    /// nothing.
    /// @pre fact.number is one more than the last applied.
    void apply(const Fact& fact);

    /// Number of the last fact applied; 0 before the first.
    [[nodiscard]] FactNumber lastApplied() const { return m_lastApplied; }
    [[nodiscard]] const std::string& name() const { return m_name; }
    [[nodiscard]] const std::string& sessionId() const { return m_sessionId; }
    [[nodiscard]] bool isLocked() const { return m_locked; }
    /// How acted-on objects are kept alike.
    [[nodiscard]] const StrategyChoice& strategy() const { return m_strategy; }
    [[nodiscard]] SessionPhase phaseAt(SessionTime t) const { return m_phase.at(t); }
    /// From when on it is over; nothing until that is decided.
    [[nodiscard]] std::optional<SessionTime> ended() const;
    /// Since it began to run.
    [[nodiscard]] Pauses pauses() const;
    /// Time spent in phase Running up to t.
    [[nodiscard]] Duration runningTime(SessionTime t) const { return m_running.integral(t); }
    /// When it was first that: of more than there was, as if the session ran on.
    /// @pre it has run
    [[nodiscard]] SessionTime whenRan(Duration runningTime) const;

    [[nodiscard]] const std::map<ParticipantId, Participant>& participants() const
    {
        return m_participants;
    }
    [[nodiscard]] const std::map<ObjectId, SharedObject>& objects() const { return m_objects; }
    /// The number of objects that those present own, without those of lessons. What nobody owns is
    /// in its place.
    [[nodiscard]] std::size_t sharedObjects() const;
    /// Also those that are closed: their numbers are not used again.
    [[nodiscard]] const std::map<StationId, Station>& stations() const { return m_stations; }
    [[nodiscard]] bool isOpen(StationId station) const;
    [[nodiscard]] bool isPresent(ParticipantId participant) const;
    /// Where the participant is, or was last; kNoStation for one who is not known.
    [[nodiscard]] StationId stationOf(ParticipantId participant) const;

    /// Who is at work at a station: whoever took up the work last, while they are there; else
    /// kNobody. A trainee who has a tube there takes up the work that nobody does, by sharing the
    /// tube and by coming in again; otherwise fact::WorkTaken decides.
    [[nodiscard]] ParticipantId atWork(StationId station) const;

private:
    struct Applier;

    FactNumber m_lastApplied;
    std::string m_name;
    std::string m_sessionId;
    bool m_locked = false;
    StrategyChoice m_strategy;
    ParameterTimeline<SessionPhase> m_phase{SessionPhase::Prepared};
    ParameterTimeline<bool> m_running{false};
    std::map<ParticipantId, Participant> m_participants;
    std::map<ObjectId, SharedObject> m_objects;
    std::map<StationId, Station> m_stations;
};

/// Who removed a participant, and why: "Ina: too loud".
[[nodiscard]] std::string removalText(const SessionState& state, const Removal& removal);

} // namespace carina
