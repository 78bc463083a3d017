#include "engine/session/session_state.h"

#include "engine/anatomy/events/neck_motion.h"
#include "engine/core/expects.h"

#include <algorithm>
#include <utility>

namespace carina
{
namespace
{

constexpr ParticipantId kHostOfSession{0};

} // namespace

HeadPosition headPositionAt(const Station& station, SessionTime t)
{
    return withinMotion(station.headPosition.at(t), station.airwayEvents.at(t));
}

/// What each kind of fact does to the state; `around` is the fact that the body came in.
struct SessionState::Applier {
    SessionState& state;
    const Fact& around;

    void operator()(const fact::SessionCreated& body) const
    {
        state.m_name = body.name;
        state.m_sessionId = body.sessionId;
    }
    void operator()(const fact::PhaseChanged& body) const
    {
        const bool running = body.phase == SessionPhase::Running;
        state.m_phase.set(around.effect, body.phase);
        state.m_running.set(around.effect, running);
        for (auto& [id, station] : state.m_stations)
            station.respiration.setRunning(around.effect, running);
    }
    void operator()(const fact::StationAdded& body) const
    {
        const auto [place, added] = state.m_stations.try_emplace(around.station);
        Station& station = place->second;
        station.id = around.station;
        station.name = body.name;
        if (!added)
            return;
        for (const auto& change : state.m_running.changes())
            station.respiration.setRunning(change.from, change.value);
    }
    void operator()(const fact::ParticipantJoined& body) const
    {
        const Participant* before = known(body.participant);
        const bool wasAway = before && !before->present;
        const StationId from = before ? before->station : around.station;
        Participant joined{body.participant, body.role, body.name, around.station, true};
        joined.muted = before && before->muted;
        joined.turn = before ? before->turn : Angle{};
        // Of a program that comes in again beside itself, the stay goes on.
        joined.since = before && before->present ? before->since : around.committed;
        state.m_participants.insert_or_assign(body.participant, std::move(joined));
        if (body.participant == kHostOfSession)
            for (auto& [id, participant] : state.m_participants)
                participant.fellSilent = false; // in an earlier run of the host
        breakOffLessonsOf(body.participant, wasAway);
        bringAlong(body.participant);
        takeUpWork(body.participant);
        passOnWork(from);
    }
    void operator()(const fact::ParticipantLeft& body) const { leave(body.participant); }
    void operator()(const fact::ParticipantFellSilent& body) const
    {
        const bool wasHere = state.isPresent(body.participant);
        leave(body.participant);
        if (wasHere) // and was not removed just before
            known(body.participant)->fellSilent = true;
    }
    void operator()(const fact::ParticipantMuted& body) const
    {
        if (Participant* participant = known(body.participant))
            participant->muted = body.muted;
    }
    void operator()(const fact::ParticipantRemoved& body) const
    {
        leave(body.participant);
        if (Participant* participant = known(body.participant))
            participant->removal = Removal{around.author, body.reason, body.banned, around.number};
    }
    void operator()(const fact::BanLifted& body) const
    {
        if (Participant* participant = known(body.participant); participant && participant->removal)
            participant->removal->banned = false;
    }
    void operator()(const fact::SessionLocked& body) const { state.m_locked = body.locked; }
    void operator()(const fact::StrategyChosen& body) const { state.m_strategy = body.choice; }
    void operator()(const fact::StationRenamed& body) const
    {
        forStations([&body](Station& station) { station.name = body.name; });
    }
    void operator()(const fact::StationClosed&) const
    {
        forStations([](Station& station) { station.closed = true; });
    }
    void operator()(const fact::ParticipantMoved& body) const
    {
        Participant* participant = known(body.participant);
        if (!participant || !state.isOpen(around.station))
            return;
        const StationId before = std::exchange(participant->station, around.station);
        participant->moved = around.committed;
        endLessonsOf(body.participant);
        bringAlong(body.participant);
        takeUpWork(body.participant);
        passOnWork(before);
    }
    void operator()(const fact::RoleCodeChanged&) const {} // of the host's secrets
    void operator()(const fact::TokenReplaced& body) const
    {
        if (Participant* participant = known(body.participant))
            participant->tokenReplaced = around.committed;
    }
    void operator()(const fact::RegistrationStated& body) const
    {
        if (Participant* participant = known(around.author))
            participant->registration = body.standing;
    }
    void operator()(const fact::WorkTaken& body) const
    {
        forStations([&body](Station& station) { station.worker = body.participant; });
    }
    void operator()(const fact::PlaceChosen& body) const
    {
        if (Participant* participant = known(body.participant))
            participant->turn = body.turn;
    }
    void operator()(const fact::LessonShown& body) const
    {
        forStations([&](Station& station) {
            station.lesson = ShownLesson{around.author, body.to, body.lesson};
            station.brokenOff.reset();
        });
    }
    void operator()(const fact::LessonEnded&) const
    {
        forStations([](Station& station) { station.lesson.reset(); });
    }
    void endLessonsOf(ParticipantId id) const
    {
        for (auto& [number, station] : state.m_stations)
            if (station.lesson && station.lesson->by == id)
                station.lesson.reset();
    }
    /// Whoever has gone cannot end what they show, and is to hear of it when they are back.
    /// @param isBack whether they come back from where they had gone to
    void breakOffLessonsOf(ParticipantId id, bool isBack) const
    {
        for (auto& [number, station] : state.m_stations) {
            const bool isTold = station.brokenOff && station.brokenOff->shown.by == id;
            if (station.lesson && station.lesson->by == id)
                station.brokenOff = BrokenOffLesson{*station.lesson, around.committed};
            else if (isTold && isBack)
                station.brokenOff->at = around.committed;
            else if (isTold)
                station.brokenOff.reset(); // they were here and have heard of it
        }
        endLessonsOf(id);
    }
    void operator()(const fact::ObjectShared& body) const
    {
        share(body);
        takeUpWork(body.owner);
    }
    void share(const fact::ObjectShared& body) const
    {
        const auto [place, added] = state.m_objects.try_emplace(
            body.object,
            SharedObject{body.object, body.owner, 1, around.station, body.kind, body.name});
        SharedObject& object = place->second;
        if (added) {
            object.sharer = body.owner;
            if (body.owner == kNobody)
                object.inPlace = object.epoch;
        }
        if (added || isLiftable(body.kind))
            return; // what was lifted stays with who has it
        own(object, body.owner);
        object.station = around.station;
        object.kind = body.kind;
        object.name = body.name;
    }
    void operator()(const fact::ObjectHandedOver& body) const
    {
        const auto object = state.m_objects.find(body.object);
        if (object == state.m_objects.end())
            return;
        if (Participant* loser = known(object->second.owner);
            loser && around.author != loser->id && body.owner != loser->id) {
            forgetWithdrawal(*loser, body.object);
            loser->withdrawn.push_back({body.object, around.author, body.owner, around.committed});
        }
        if (Participant* heir = known(body.owner))
            forgetWithdrawal(*heir, body.object);
        own(object->second, body.owner);
    }
    static void forgetWithdrawal(Participant& participant, ObjectId object)
    {
        std::erase_if(participant.withdrawn,
                      [object](const Withdrawal& each) { return each.object == object; });
    }
    void operator()(const fact::ObjectWanted& body) const
    {
        const auto object = state.m_objects.find(body.object);
        if (object == state.m_objects.end() || object->second.owner == around.author
            || object->second.owner == kNobody)
            return;
        std::vector<ParticipantId>& asking = object->second.wantedBy;
        if (!body.wanted)
            std::erase(asking, around.author);
        else if (std::ranges::find(asking, around.author) == asking.end())
            asking.push_back(around.author);
    }
    void operator()(const fact::AnatomyChosen& body) const
    {
        forStations([&body](Station& station) {
            station.anatomyHash = body.contentHash;
            station.anatomyName = body.name;
            station.lesson.reset(); // of parts of the patient before
            station.brokenOff.reset();
        });
    }
    void operator()(const fact::BreathingRateSet& body) const
    {
        forStations(
            [&](Station& station) { station.respiration.setRate(around.effect, body.rate); });
    }
    void operator()(const fact::TidalVolumeSet& body) const
    {
        forStations([&](Station& station) {
            station.respiration.setTidalVolume(around.effect, body.tidalVolume);
        });
    }
    void operator()(const fact::InspiratoryFractionSet& body) const
    {
        forStations([&](Station& station) {
            station.respiration.setInspiratoryFraction(around.effect, body.fraction);
        });
    }
    void operator()(const fact::PatientBuildSet& body) const
    {
        forStations(
            [&](Station& station) { station.respiration.setBuild(around.effect, body.build); });
    }
    void operator()(const fact::LungConditionsSet& body) const
    {
        forStations([&](Station& station) {
            station.respiration.setConditions(around.effect, body.conditions);
        });
    }
    void operator()(const fact::VentilatorSet& body) const
    {
        forStations([&](Station& station) {
            station.respiration.setVentilator(around.effect, body.settings);
        });
    }
    void operator()(const fact::TubePlaced& body) const
    {
        forStations(
            [&](Station& station) { station.respiration.setTube(around.effect, body.tube); });
    }
    void operator()(const fact::BodyPositionSet& body) const
    {
        forStations([&](Station& station) {
            station.respiration.setPosition(around.effect, body.position);
        });
    }
    void operator()(const fact::BreathingStopped& body) const
    {
        forStations([&](Station& station) {
            station.respiration.setOwnBreathing(around.effect, {body.stopped, body.over});
        });
    }
    void operator()(const fact::BagSqueezed& body) const
    {
        forStations([&](Station& station) { station.respiration.setBag(around.effect, body.bag); });
    }
    void operator()(const fact::ManikinBreathed& body) const
    {
        forStations([&](Station& station) {
            station.respiration.addBreath({around.effect, body.began});
        });
    }
    void operator()(const fact::RespirationCheckpoint& body) const
    {
        forStations(
            [&](Station& station) { station.respiration.addBreathing(body.at, body.state); });
    }
    void operator()(const fact::CapnographCheckpoint& body) const
    {
        forStations(
            [&](Station& station) { station.respiration.addCapnograph(body.at, body.state); });
    }
    void operator()(const fact::BodyCheckpoint& body) const
    {
        forStations([&](Station& station) {
            station.respiration.addBody(body.at, body.state);
            station.airwayEvents.forgetBefore(station.respiration.keptFrom());
            station.headPosition.forgetBefore(station.respiration.keptFrom());
        });
    }
    void operator()(const fact::AirwayEventsSet& body) const
    {
        forStations([&](Station& station) {
            station.airwayEvents.set(around.effect, body.events, body.over);
        });
    }
    void operator()(const fact::GasSupplySet& body) const
    {
        forStations([&](Station& station) { station.respiration.setGas(around.effect, body.gas); });
    }
    void operator()(const fact::DrugGiven& body) const
    {
        forStations([&](Station& station) { station.respiration.give(around.effect, body.dose); });
    }
    void operator()(const fact::CuffSet& body) const
    {
        forStations(
            [&](Station& station) { station.respiration.setCuff(around.effect, body.inflated); });
    }
    void operator()(const fact::StyletDrawn&) const
    {
        forStations([&](Station& station) { station.respiration.drawStylet(around.effect); });
    }
    void operator()(const fact::TryEnded&) const
    {
        forStations([&](Station& station) {
            if (station.tryEnds.size() == Station::kTryEndsKept)
                station.tryEnds.erase(station.tryEnds.begin());
            station.tryEnds.push_back(around.effect);
        });
    }
    void operator()(const fact::TubeObstructed& body) const
    {
        forStations([&](Station& station) {
            station.respiration.setObstruction(around.effect, body.share);
        });
    }
    void operator()(const fact::IntubationNoted& body) const
    {
        forStations([&](Station& station) {
            station.respiration.noteIntubation(around.effect, body.event, body.innerDiameter);
        });
    }
    void operator()(const fact::HeadPositionSet& body) const
    {
        forStations([&](Station& station) {
            station.headPosition.set(around.effect, body.position, body.over);
        });
    }

    /// A trainee who has a tube at a station where nobody is at work is at work there.
    void takeUpWork(ParticipantId id) const
    {
        const Participant* participant = known(id);
        if (participant == nullptr || participant->role != Role::Trainee)
            return;
        const StationId where = participant->station;
        const auto station = state.m_stations.find(where);
        const bool hasTube = std::ranges::any_of(state.m_objects, [&](const auto& entry) {
            const SharedObject& object = entry.second;
            return object.owner == id && object.station == where && object.kind == ObjectKind::Tube;
        });
        if (station != state.m_stations.end() && hasTube && state.atWork(where) == kNobody)
            station->second.worker = id;
    }
    /// Work that nobody does any more is for the first of the trainees there who has a tube.
    void passOnWork(StationId where) const
    {
        for (const auto& [id, who] : state.m_participants)
            if (who.present && who.station == where)
                takeUpWork(id);
    }
    void leave(ParticipantId id) const
    {
        if (Participant* participant = known(id); participant && participant->present) {
            participant->present = false;
            participant->left = around.committed;
            passOnWork(participant->station);
        }
        if (Participant* participant = known(id))
            participant->fellSilent = false;
        breakOffLessonsOf(id, false);
        for (auto& [number, object] : state.m_objects) {
            std::erase(object.wantedBy, id);
            if (object.owner == id && isLiftable(object.kind))
                own(object, kNobody);
        }
    }
    [[nodiscard]] Participant* known(ParticipantId id) const
    {
        const auto participant = state.m_participants.find(id);
        return participant == state.m_participants.end() ? nullptr : &participant->second;
    }
    static void own(SharedObject& object, ParticipantId owner)
    {
        if (std::exchange(object.owner, owner) != owner)
            ++object.epoch;
        std::erase(object.wantedBy, owner);
        if (owner != kNobody)
            return;
        object.inPlace = object.epoch;
        object.wantedBy.clear();
    }
    /// What a participant carries is at their station. Elsewhere only instructors own or ask for
    /// anything: what a trainee lifted out there is put back.
    void bringAlong(ParticipantId id) const
    {
        const Participant& carrier = state.m_participants.at(id);
        for (auto& [number, object] : state.m_objects) {
            if (object.station == carrier.station)
                continue;
            if (object.owner == id && isCarried(object.kind))
                object.station = carrier.station;
            if (object.station == carrier.station || carrier.role == Role::Instructor)
                continue;
            std::erase(object.wantedBy, id);
            if (object.owner == id)
                own(object, isLiftable(object.kind) ? kNobody : kHostOfSession);
        }
    }
    /// Calls `change` with each open station that the fact is about.
    template <class Change> void forStations(const Change& change) const
    {
        for (auto& [id, station] : state.m_stations)
            if (!station.closed && (around.station == id || around.station == kAllStations))
                change(station);
    }
};

std::size_t SessionState::sharedObjects() const
{
    const auto isShared = [this](const auto& entry) {
        const auto owner = m_participants.find(entry.second.owner);
        return owner != m_participants.end() && owner->second.present
               && !isOfLesson(entry.second.kind);
    };
    return std::size_t(std::ranges::count_if(m_objects, isShared));
}

bool SessionState::isOpen(StationId station) const
{
    const auto found = m_stations.find(station);
    return found != m_stations.end() && !found->second.closed;
}

bool SessionState::isPresent(ParticipantId participant) const
{
    const auto found = m_participants.find(participant);
    return found != m_participants.end() && found->second.present;
}

StationId SessionState::stationOf(ParticipantId participant) const
{
    const auto found = m_participants.find(participant);
    return found == m_participants.end() ? kNoStation : found->second.station;
}

std::optional<SessionTime> SessionState::ended() const
{
    const auto changes = m_phase.changes();
    const bool isOver = !changes.empty() && changes.back().value == SessionPhase::Ended;
    return isOver ? std::optional{changes.back().from} : std::nullopt;
}

SessionTime SessionState::whenRan(Duration runningTime) const
{
    const auto changes = m_running.changes();
    const auto first = std::ranges::find_if(changes, [](const auto& each) { return each.value; });
    CARINA_EXPECTS(first != changes.end());
    return pauses().after(first->from, runningTime);
}

Pauses SessionState::pauses() const
{
    Pauses pauses;
    std::optional<SessionTime> since;
    for (const auto& change : m_running.changes()) {
        if (change.value && since)
            pauses.add(*std::exchange(since, std::nullopt), change.from);
        else if (!change.value && !since && change.before > Duration{})
            since = change.from;
    }
    if (since)
        pauses.add(*since, SessionTime::max());
    return pauses;
}

ParticipantId SessionState::atWork(StationId station) const
{
    const auto place = m_stations.find(station);
    if (place == m_stations.end())
        return kNobody;
    const auto worker = m_participants.find(place->second.worker);
    const bool isThere = worker != m_participants.end() && worker->second.present
                         && worker->second.station == station;
    return isThere ? worker->first : kNobody;
}

std::string removalText(const SessionState& state, const Removal& removal)
{
    const auto by = state.participants().find(removal.by);
    const std::string who = by == state.participants().end() ? std::string{} : by->second.name;
    return who.empty() || removal.reason.empty() ? who + removal.reason
                                                 : who + ": " + removal.reason;
}

void SessionState::apply(const Fact& fact)
{
    CARINA_EXPECTS(fact.number.value == m_lastApplied.value + 1);
    std::visit(Applier{*this, fact}, fact.body);
    m_lastApplied = fact.number;
}

} // namespace carina
