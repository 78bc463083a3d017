#include "engine/session/session_authority.h"

#include "engine/core/overloaded.h"
#include "engine/session/conduct_rules.h"
#include "engine/session/facts/fact_rules.h"
#include "engine/session/facts/plain_name.h"
#include "engine/session/lesson_rules.h"
#include "engine/session/news_rules.h"
#include "engine/session/object_rules.h"
#include "engine/session/participant_limits.h"
#include "engine/session/people_rules.h"
#include "engine/session/respiration/respiration_rules.h"
#include "engine/session/station_rules.h"

#include <algorithm>
#include <cstdint>
#include <string>

namespace carina
{

namespace
{

constexpr ParticipantId kHost{0};
constexpr std::uint16_t kLastId = kNobody.value - 1;

template <class... Facts> bool isOneOf(const FactBody& body)
{
    return (std::holds_alternative<Facts>(body) || ...);
}

/// Drives a patient or the phase, so that it has to take effect everywhere at once.
bool takesEffectLater(const FactBody& body)
{
    return isOneOf<fact::PhaseChanged, fact::AnatomyChosen, fact::BreathingRateSet,
                   fact::TidalVolumeSet, fact::InspiratoryFractionSet, fact::PatientBuildSet,
                   fact::LungConditionsSet, fact::VentilatorSet, fact::TubePlaced,
                   fact::BodyPositionSet, fact::BreathingStopped, fact::BagSqueezed,
                   fact::ManikinBreathed, fact::AirwayEventsSet, fact::HeadPositionSet,
                   fact::GasSupplySet, fact::DrugGiven, fact::CuffSet, fact::StyletDrawn,
                   fact::IntubationNoted, fact::TubeObstructed, fact::TryEnded>(body);
}

/// The id of the entry that is the same, else the next free one; 0 where none is left.
template <class Entries, class IsSame> auto idFor(const Entries& entries, IsSame isSame)
{
    using EntryId = typename Entries::key_type;
    const auto known = std::ranges::find_if(
        entries, [&isSame](const auto& entry) { return isSame(entry.second); });
    if (known != entries.end())
        return known->first;
    if (entries.empty())
        return EntryId{1};
    const auto last = entries.rbegin()->first.value;
    return last >= kLastId ? EntryId{0} : EntryId{static_cast<decltype(EntryId::value)>(last + 1)};
}

/// Gives or checks an id: an explicit one has to name an entry that is the same.
template <class Entries, class IsSame>
Result<void> settleId(typename Entries::key_type& id, const Entries& entries, const char* what,
                      IsSame isSame)
{
    if (id.value == 0) {
        id = idFor(entries, isSame);
        return id.value == 0 ? fail(Errc::OutOfRange, std::string{"no number left for a "} + what)
                             : Result<void>{};
    }
    const auto entry = entries.find(id);
    if (entry == entries.end() || !isSame(entry->second))
        return fail(Errc::OutOfRange, std::string{what} + " " + std::to_string(id.value));
    return {};
}

Result<void> checkParticipant(const SessionState& state, ParticipantId id)
{
    if (!state.participants().contains(id))
        return fail(Errc::OutOfRange, "participant " + std::to_string(id.value));
    return {};
}

/// What stays at its station is another object at each; who has it does not matter for what can be
/// lifted out.
bool isSameObject(const SharedObject& known, StationId station, const fact::ObjectShared& shared)
{
    return known.kind == shared.kind && known.name == shared.name
           && (isLiftable(known.kind) || known.owner == shared.owner)
           && (isCarried(known.kind) || known.station == station);
}

Result<void> settleIds(const SessionState& state, ParticipantId author, StationId station,
                       FactBody& body)
{
    return std::visit(
        Overloaded{
            [&](fact::ParticipantJoined& joined) {
                return settleId(joined.participant, state.participants(), "participant",
                                [&](const Participant& known) {
                                    return known.name == joined.name && known.role == joined.role;
                                });
            },
            [&](fact::ParticipantLeft& left) { return checkParticipant(state, left.participant); },
            [&](fact::ParticipantFellSilent& silent) {
                return checkParticipant(state, silent.participant);
            },
            [&](fact::ObjectShared& shared) {
                return settleId(shared.object, state.objects(), "object",
                                [&](const SharedObject& known) {
                                    return isSameObject(known, station, shared);
                                });
            },
            [&](fact::ObjectHandedOver& handed) { return checkHandOver(state, author, handed); },
            [&](fact::ObjectWanted& wanted) { return checkWish(state, wanted); },
            [&](fact::ParticipantMoved& moved) {
                return checkParticipant(state, moved.participant);
            },
            [](auto&) { return Result<void>{}; }},
        body);
}

/// What a trainee may do: state how their registration stands, choose where others see them, and
/// for the station they are at share what is their own, ask for what is not, lift out what is in
/// its place, say when the manikin breathes and what they do with cuff and stylet, and, of the work
/// that they do, squeeze the bag, end a try and pass it on. An observer may do nothing.
bool mayDoForThemselves(const SessionState& state, const Participant& author, StationId station,
                        const FactBody& body)
{
    if (author.role != Role::Trainee)
        return false;
    if (std::holds_alternative<fact::RegistrationStated>(body))
        return true;
    if (const auto* chosen = std::get_if<fact::PlaceChosen>(&body))
        return chosen->participant == author.id;
    if (author.station != station)
        return false;
    return std::visit(
        Overloaded{
            [&](const fact::ObjectShared& f) {
                const auto known = state.objects().find(f.object);
                return f.owner == author.id && f.kind != ObjectKind::Patient && !isOfLesson(f.kind)
                       && (known == state.objects().end() || known->second.owner == author.id);
            },
            [&](const fact::ObjectHandedOver& f) { return mayPassOn(state, author, f); },
            [&](const fact::ObjectWanted& f) {
                return state.objects().at(f.object).station == station;
            },
            [](const fact::ManikinBreathed&) { return true; },
            [](const fact::CuffSet&) { return true; },
            [](const fact::StyletDrawn&) { return true; },
            [&](const fact::BagSqueezed&) { return state.atWork(station) == author.id; },
            [&](const fact::TryEnded&) { return state.atWork(station) == author.id; },
            [&](const fact::WorkTaken& f) { return mayPassOnWork(state, author, station, f); },
            [](const auto&) { return false; }},
        body);
}

/// Nobody else creates a session, says what can be lifted out, knows all that was decided by the
/// time of a checkpoint, or sees who comes and goes, and by which token.
bool isOfTheHostAlone(const FactBody& body)
{
    if (const auto* shared = std::get_if<fact::ObjectShared>(&body))
        return isLiftable(shared->kind);
    return isOneOf<fact::SessionCreated, fact::RespirationCheckpoint, fact::CapnographCheckpoint,
                   fact::BodyCheckpoint, fact::ParticipantJoined, fact::ParticipantLeft,
                   fact::ParticipantFellSilent, fact::TokenReplaced>(body);
}

/// An intubation is followed from the poses of the tools at a station, by one program: that of who
/// is at work there, or the host's where it simulates the station.
bool mayAuthor(const SessionState& state, const Participant& author, StationId station,
               const FactBody& body)
{
    if (std::holds_alternative<fact::IntubationNoted>(body))
        return state.atWork(station) == author.id;
    const bool instructs = author.role == Role::Instructor && !isOfTheHostAlone(body);
    return instructs || mayDoForThemselves(state, author, station, body);
}

/// Whoever is new takes a plain name, and none that looks like that of a participant there ever
/// was. Only a proposal is judged by this, not a log that is read: it depends on the version of
/// Unicode.
Result<void> checkNewName(const NameIndex& names, const fact::ParticipantJoined& joined)
{
    return checkName(joined.name).and_then([&]() -> Result<void> {
        const std::string* other = names.alike(joined.name);
        return other == nullptr ? Result<void>{} : fail(Errc::NameUnclear, *other);
    });
}

/// As many participants of a role as may be present, and as may ever have been. Who was away for a
/// while finds the place that is kept for them, also where somebody has filled all others.
Result<void> checkNumbers(const SessionState& state, const NameIndex& index, SessionTime now,
                          const FactBody& body)
{
    const auto* joined = std::get_if<fact::ParticipantJoined>(&body);
    if (joined == nullptr)
        return {};
    std::size_t places = 0;
    std::size_t names = 0;
    for (const auto& [id, other] : state.participants())
        if (other.role == joined->role && id != joined->participant) {
            ++names;
            places += hasPlace(other, now) ? 1 : 0;
        }
    const auto known = state.participants().find(joined->participant);
    const bool isNew = known == state.participants().end();
    const bool comesBack = !isNew && hasPlace(known->second, now);
    if ((!comesBack && places >= mostPresentOf(joined->role))
        || (isNew && names >= mostNamesOf(joined->role)))
        return fail(Errc::SessionFull);
    return isNew ? checkNewName(index, *joined) : Result<void>{};
}

Result<void> checkPermission(const SessionState& state, ParticipantId authorId, StationId station,
                             const FactBody& body)
{
    const bool isAdmission =
        authorId == kNobody && std::holds_alternative<fact::ParticipantJoined>(body);
    if (authorId == kHost || isAdmission)
        return {};
    const auto author = state.participants().find(authorId);
    if (author == state.participants().end())
        return fail(Errc::NotPermitted, "participant " + std::to_string(authorId.value));
    const bool isSafety = std::holds_alternative<fact::RegistrationStated>(body);
    if (author->second.muted && !isSafety)
        return fail(Errc::Muted, author->second.name);
    if (!mayAuthor(state, author->second, station, body))
        return fail(Errc::NotPermitted, author->second.name);
    return {};
}

/// Creation comes first and once; after the end people and objects only come and go.
Result<void> checkMoment(const SessionState& state, const FactBody& body)
{
    const bool creates = std::holds_alternative<fact::SessionCreated>(body);
    if (creates != (state.lastApplied().value == 0))
        return fail(Errc::NotPermitted, "a session is created first and once");
    if (state.phaseAt(SessionTime::max()) != SessionPhase::Ended || isAboutConduct(body))
        return {};
    return std::visit(Overloaded{[](const fact::ParticipantJoined&) { return Result<void>{}; },
                                 [](const fact::ParticipantLeft&) { return Result<void>{}; },
                                 [](const fact::ParticipantFellSilent&) { return Result<void>{}; },
                                 [](const fact::ObjectShared&) { return Result<void>{}; },
                                 [](const fact::ObjectHandedOver&) { return Result<void>{}; },
                                 [](const fact::ObjectWanted&) { return Result<void>{}; },
                                 [](const fact::RegistrationStated&) { return Result<void>{}; },
                                 [](const fact::LessonShown&) { return Result<void>{}; },
                                 [](const fact::LessonEnded&) { return Result<void>{}; },
                                 [&](const auto&) -> Result<void> {
                                     return fail(Errc::SessionEnded, state.name());
                                 }},
                      body);
}

std::optional<SessionTime> timeOfCheckpoint(const FactBody& body)
{
    if (const auto* breathing = std::get_if<fact::RespirationCheckpoint>(&body))
        return breathing->at;
    if (const auto* capnograph = std::get_if<fact::CapnographCheckpoint>(&body))
        return capnograph->at;
    if (const auto* whole = std::get_if<fact::BodyCheckpoint>(&body))
        return whole->at;
    return std::nullopt;
}

/// Whoever is to go on from a checkpoint at the present has to find it in the past.
Result<void> checkCheckpoint(SessionTime now, const FactBody& body)
{
    if (const auto at = timeOfCheckpoint(body); at && *at > now)
        return fail(Errc::OutOfRange, "a checkpoint of what is to come");
    return {};
}

/// By what was last decided about each patient, whenever it takes effect.
Result<void> checkPatient(const SessionState& state, StationId id, const FactBody& body)
{
    const auto* set = std::get_if<fact::TidalVolumeSet>(&body);
    if (!set)
        return {};
    for (const auto& [number, station] : state.stations()) {
        if (station.closed || (id != number && id != kAllStations))
            continue;
        const PatientBuild build = station.respiration.settingsAt(SessionTime::max()).build;
        if (auto breathed = checkTidalVolume(build, set->tidalVolume); !breathed)
            return breathed;
    }
    return {};
}

bool canFollow(SessionPhase before, SessionPhase after)
{
    switch (before) {
    case SessionPhase::Prepared:
        return after == SessionPhase::Running || after == SessionPhase::Ended; // begun by mistake
    case SessionPhase::Running:
        return after == SessionPhase::Paused || after == SessionPhase::Ended;
    case SessionPhase::Paused:
        return after == SessionPhase::Running || after == SessionPhase::Ended;
    case SessionPhase::Ended:
        break;
    }
    return false;
}

Result<void> checkPhase(const SessionState& state, const FactBody& body)
{
    const auto* change = std::get_if<fact::PhaseChanged>(&body);
    if (change && !canFollow(state.phaseAt(SessionTime::max()), change->phase))
        return fail(Errc::OutOfRange, "a phase that cannot follow the present one");
    return {};
}

} // namespace

SessionAuthority::SessionAuthority(const std::vector<Fact>& log)
{
    for (const Fact& fact : log)
        commit(fact);
}

Result<Fact> SessionAuthority::judge(const Proposal& proposal, SessionTime now,
                                     Duration slowestPath) const
{
    Fact fact{FactNumber{m_state.lastApplied().value + 1},
              proposal.id,
              proposal.author,
              proposal.station,
              now,
              now,
              proposal.body};
    if (takesEffectLater(fact.body))
        fact.effect = std::max(now + std::max(kShortestLead, slowestPath), m_latestEffect);
    const Result<void> verdict =
        settleIds(m_state, fact.author, fact.station, fact.body)
            .and_then([&] { return settledStation(m_state, fact.station, fact.body); })
            .map([&](StationId station) { fact.station = station; })
            .and_then([&] { return checkNamed(m_state, fact.body); })
            .and_then([&] { return checkPeople(m_state, fact.station, fact.body); })
            .and_then(
                [&] { return checkPermission(m_state, fact.author, fact.station, fact.body); })
            .and_then([&] { return checkMoment(m_state, fact.body); })
            .and_then([&] { return checkBody(fact.body); })
            .and_then([&] { return checkEntry(m_state, fact.body); })
            .and_then([&] { return checkConduct(m_state, fact.body); })
            .and_then([&] { return checkNumbers(m_state, m_names, now, fact.body); })
            .and_then([&] {
                const auto* shared = std::get_if<fact::ObjectShared>(&fact.body);
                return shared ? checkShared(m_state, fact.station, *shared) : Result<void>{};
            })
            .and_then([&] { return checkStation(m_state, fact.station, fact.body); })
            .and_then([&] { return checkStations(m_state, fact.station, fact.body); })
            .and_then([&] { return checkLessons(m_state, fact.station, fact.body); })
            .and_then([&] { return checkPatient(m_state, fact.station, fact.body); })
            .and_then([&] { return checkPhase(m_state, fact.body); })
            .and_then([&] { return checkCheckpoint(now, fact.body); })
            .and_then([&] { return checkNews(m_state, fact); });
    if (!verdict)
        return tl::unexpected(verdict.error());
    return fact;
}

std::optional<FactNumber> SessionAuthority::settled(ProposalId id) const
{
    const auto known = m_settled.find(id);
    if (known == m_settled.end())
        return std::nullopt;
    return known->second;
}

void SessionAuthority::commit(const Fact& fact)
{
    m_state.apply(fact);
    if (const auto* joined = std::get_if<fact::ParticipantJoined>(&fact.body))
        m_names.add(joined->name);
    m_settled.emplace(fact.proposal, fact.number);
    if (takesEffectLater(fact.body))
        m_latestEffect = std::max(m_latestEffect, fact.effect);
}

} // namespace carina
