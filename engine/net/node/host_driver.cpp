#include "engine/net/node/host_driver.h"

#include "engine/net/entry/session_identity.h"
#include "engine/net/entry/token_message.h"
#include "engine/net/node/host_clock.h"
#include "engine/session/facts/fact_codec.h"
#include "engine/session/participant_limits.h"
#include "engine/session/station_rules.h"

#include <QRandomGenerator>

#include <algorithm>
#include <utility>

namespace carina
{
namespace
{

constexpr ParticipantId kSelf{0};
/// Shortest interval of storing actions, so that rapid actions do not keep the disk busy.
constexpr Duration kKeepInterval = std::chrono::milliseconds{100};
constexpr Duration kWatchInterval = std::chrono::milliseconds{500};

std::uint64_t hostRandom() { return QRandomGenerator::system()->generate64(); }

Result<std::vector<Fact>> decodeLog(const std::vector<FactRecord>& records)
{
    std::vector<Fact> facts;
    for (const FactRecord& record : records) {
        auto fact = fromRecord(record);
        if (!fact)
            return fail(Errc::StoreCorrupt,
                        "fact " + std::to_string(record.number.value) + ": " + fact.error().detail);
        facts.push_back(*std::move(fact));
    }
    return facts;
}

} // namespace

Result<std::unique_ptr<HostDriver>> HostDriver::open(const HostSettings& settings,
                                                     std::unique_ptr<FactStore> store,
                                                     NodeBoard& board, LocalTime now)
{
    auto records = store->load();
    if (!records)
        return tl::unexpected(records.error());
    const auto facts = decodeLog(*records);
    if (!facts)
        return tl::unexpected(facts.error());
    const auto anchor = store->clockAnchor();
    if (!anchor)
        return tl::unexpected(anchor.error());
    const auto actions = store->actions();
    if (!actions)
        return tl::unexpected(actions.error());

    const bool isNew = records->empty();
    const std::string bootId = readBootId();
    const auto lastCommitted = isNew ? std::nullopt : std::optional{records->back().committed};
    const Duration offset = sessionClockOffset(*anchor, bootId, lastCommitted, now, hostRandom());
    if (const auto kept = store->setClockAnchor({bootId, offset}); !kept)
        return tl::unexpected(kept.error());

    std::unique_ptr<HostDriver> driver{new HostDriver{SessionAuthority{*facts}, board, now}};
    const std::string sessionId =
        isNew ? newSessionId() : driver->m_ledger.stored().state().sessionId();
    auto access = HostAccess::open(settings.secrets, sessionId, settings.derive);
    if (!access)
        return tl::unexpected(access.error());
    driver->m_access = *std::move(access);
    driver->m_entry =
        std::make_unique<HostEntry>(driver->m_ledger, *driver->m_access, driver->m_paths);
    board.setJoinCodes(driver->m_access->codes());
    if (const auto revoked = driver->revokeBanned(); !revoked)
        return tl::unexpected(revoked.error());
    if (*anchor && lastCommitted && contradictsLog(**anchor, bootId, *lastCommitted, now))
        driver->m_storeFault = Error{Errc::ClockLost, {}};
    driver->startCore(sessionId, *std::move(records), offset);
    driver->m_core->setStrategy(driver->m_ledger.stored().state().strategy(), now);
    driver->resumeActions(*actions, now);
    if (const auto begun = isNew ? driver->begin(settings, sessionId, now) : Result<void>{}; !begun)
        return tl::unexpected(begun.error());
    driver->joinItself(settings.participantName, now);
    if (const auto chosen = driver->chooseStrategy(settings, now); !chosen)
        return tl::unexpected(chosen.error());
    if (const auto kept = store->append(driver->m_ledger.handOver()); !kept)
        return fail(Errc::StoreFailed, kept.error().detail);
    driver->stored(driver->m_ledger.takeHandedOver(), now);
    driver->m_writer = std::make_unique<StoreWriter>(std::move(store));
    driver->show(now);
    return driver;
}

HostDriver::HostDriver(SessionAuthority authority, NodeBoard& board, LocalTime now)
    : m_ledger{std::move(authority)}, m_board{board}, m_returnsEnd{now + kPeerTimeout}
{
}

void HostDriver::startCore(const std::string& sessionId, std::vector<FactRecord> log,
                           Duration clockOffset)
{
    HostRules rules{
        [this](const Hello& hello, LocalTime now) {
            return m_paths.hearsHello(m_speaker, now) ? m_entry->identify(
                       m_speaker, hello, m_core->log(), m_core->sessionTime(now))
                                                      : Result<Identity>{fail(Errc::TooMuchSent)};
        },
        [this](const Hello& hello, LocalTime now) {
            return m_entry->admit(m_speaker, hello, m_core->log(), m_core->sessionTime(now), now,
                                  [&](const Proposal& join) { return decide(join, now); });
        },
        [this](ProposalId proposal) { return m_ledger.decided().settled(proposal).has_value(); },
        [this](const ProposalRecord& record, LocalTime now) { return decideForPeer(record, now); },
        [this](ParticipantId participant, Leave why, LocalTime now) {
            left(participant, why, now);
        },
        [this](ParticipantId participant) {
            const Participant& who = m_ledger.stored().state().participants().at(participant);
            return who.role != Role::Observer && !who.muted;
        },
        [this](ParticipantId participant) {
            return limitsOf(m_ledger.stored().state().participants().at(participant).role);
        },
        [this](ParticipantId participant) {
            return m_ledger.stored().state().stationOf(participant);
        },
        [this](PeerAddress path) { return m_paths.sharedBudget(path); },
        [this](ParticipantId participant) {
            return m_ledger.stored().state().participants().at(participant).role
                   == Role::Instructor;
        },
        [this](ParticipantId participant) {
            const SessionState& state = m_ledger.stored().state();
            return state.atWork(state.stationOf(participant)) == participant;
        }};
    m_core = std::make_unique<SyncHost>(sessionKey(sessionId), std::move(log), clockOffset,
                                        std::move(rules));
    for (const auto& [id, object] : m_ledger.stored().state().objects())
        share(object);
}

void HostDriver::resumeActions(const std::vector<EventCpo>& actions, LocalTime now)
{
    for (EventCpo event : actions) {
        // After a reboot the session goes on from its last fact, which may be before this.
        event.start = std::min(event.start, m_core->sessionTime(now));
        m_core->restore(event);
    }
}

Result<void> HostDriver::begin(const HostSettings& settings, const std::string& sessionId,
                               LocalTime now)
{
    return decideByHost(kNoStation, fact::SessionCreated{settings.sessionName, sessionId}, now)
        .and_then([&] {
            return decideByHost(kNoStation, fact::StationAdded{settings.firstStation}, now);
        });
}

Result<void> HostDriver::chooseStrategy(const HostSettings& settings, LocalTime now)
{
    StrategyChoice choice = m_ledger.decided().state().strategy();
    if (!settings.strategy || std::exchange(choice.kind, *settings.strategy) == *settings.strategy)
        return {};
    return decideByHost(kNoStation, fact::StrategyChosen{choice}, now);
}

void HostDriver::joinItself(const std::string& name, LocalTime now)
{
    // Not judged: the authority would give the host a number as it does to everybody else.
    const SessionTime time = m_core->sessionTime(now);
    const FactNumber number{m_ledger.decided().state().lastApplied().value + 1};
    const fact::ParticipantJoined joined{kSelf, Role::Instructor, name};
    const StationId last = m_ledger.decided().state().stationOf(kSelf);
    const StationId station = m_ledger.decided().state().isOpen(last)
                                  ? last
                                  : firstOpenStation(m_ledger.decided().state());
    m_epoch = static_cast<std::uint16_t>(number.value);
    m_ledger.enter({number, ProposalId{hostRandom()}, kSelf, station, time, time, joined});
}

Result<FactNumber> HostDriver::decide(const Proposal& proposal, LocalTime now)
{
    if (const auto number = m_ledger.decided().settled(proposal.id))
        return *number;
    return m_ledger.decided()
        .judge(proposal, m_core->sessionTime(now),
               m_core->slowestPath() + m_storing + HostView::showsWithin(m_ledger.stored().state()))
        .and_then([this](const Fact& fact) {
            return prepare(fact).map([&] {
                m_ledger.enter(fact);
                return fact.number;
            });
        });
}

Result<void> HostDriver::decideForPeer(const ProposalRecord& proposal, LocalTime now)
{
    if (m_ledger.unstored() >= kMostUnstored)
        return fail(Errc::StoreFailed, "the disk is too slow");
    return fromRecord(proposal)
        .and_then([&](const Proposal& read) { return decide(read, now); })
        .map([](FactNumber) {});
}

Result<void> HostDriver::decideByHost(StationId station, FactBody body, LocalTime now)
{
    const auto fact = decide({ProposalId{hostRandom()}, kSelf, station, std::move(body)}, now);
    if (fact)
        return {};
    m_refusal = fact.error();
    return tl::unexpected(fact.error());
}

void HostDriver::stored(std::size_t count, LocalTime now)
{
    for (; count > 0; --count) {
        const auto [fact, record] = m_ledger.storeOldest();
        m_core->append(record);
        carryOut(fact.body);
        if (const auto* chosen = std::get_if<fact::StrategyChosen>(&fact.body))
            m_core->setStrategy(chosen->choice, now);
        if (const auto object = objectOf(fact.body))
            share(m_ledger.stored().state().objects().at(*object));
        if (mayChangeOwners(fact.body))
            for (const auto& [id, object] : m_ledger.stored().state().objects())
                share(object);
        m_hostView.changed();
    }
}

void HostDriver::giveUp(const Error& why, LocalTime now)
{
    // What was decided since was decided on the ground of what is not stored.
    for (const FactRecord& record : m_ledger.giveUp())
        m_core->giveUp(record, Errc::StoreFailed, now);
    m_entry->giveUp();
    m_publications.forget();           // what was to be shared is not
    m_returnsEnd = now + kPeerTimeout; // who left meanwhile is found absent
    m_refusal = Error{Errc::StoreFailed, why.detail};
    m_access->giveUp();
    m_nextSecrets = now + kWatchInterval;
}

void HostDriver::share(const SharedObject& object)
{
    m_core->share(object.id, {object.owner, object.epoch, object.inPlace});
    if (object.owner == kSelf || !m_ledger.stored().state().isPresent(object.owner))
        m_board.objects.remove(object.id);
    else
        m_board.objects.add(object.id, object.owner, object.station);
}

std::optional<ActedPose> HostDriver::shownPose(ObjectId object, SessionTime t) const
{
    return shownPoseOf(m_core->actions(), m_board.objects, object, t, m_core->localTime(t));
}

void HostDriver::compareViews(LocalTime now)
{
    m_nextViews = LocalTime::max();
    if (m_ledger.stored().state().objects().empty())
        return;
    const SessionTime session = m_core->sessionTime(now);
    for (const ShownPose& own : m_views.advance(m_ledger.stored().state(), kSelf, session))
        m_core->tellShown(own);
    m_nextViews = now + (m_views.nextDue(session) - session);
}

void HostDriver::propose(StationId station, FactBody body, LocalTime now)
{
    const bool isAwaited = !isByItself(body);
    if (isAwaited)
        m_refusal.reset();
    const auto fact = decide({ProposalId{hostRandom()}, kSelf, station, body}, now);
    if (fact && isAwaited)
        m_hostView.await(*fact, std::move(body));
    if (!fact && (isAwaited || fact.error().code == Errc::StoreFailed))
        m_refusal = fact.error();
}

void HostDriver::publish(ObjectKind kind, std::string name, PoseSource newest)
{
    m_publications.add(kind, std::move(name), std::move(newest));
}

void HostDriver::publishShape(ObjectKind kind, ShapeSource shape)
{
    m_publications.bend(kind, std::move(shape));
}

void HostDriver::act(ObjectId object, const ObjectAction& action, LocalTime now)
{
    m_refusal.reset();
    if (const auto done = m_core->act(object, action, now); !done)
        m_refusal = done.error();
}

void HostDriver::sendOwnStreams(LocalTime now)
{
    for (auto& [station, object] : m_publications.takeUnknown(m_ledger.decided().state(), kSelf))
        static_cast<void>(decideByHost(station, std::move(object), now)); // a refusal is shown
    for (const auto& [station, cpo] :
         m_publications.sample(m_ledger.stored().state(), kSelf, now)) {
        m_core->publish({kSelf, m_epoch, station, cpo}, now);
        m_board.objects.sent(kSelf, cpo);
    }
}

void HostDriver::handOver(LocalTime now)
{
    if (m_writer->isBusy())
        return;
    StoreJob job;
    job.facts = m_ledger.handOver();
    if (now >= m_nextKeep) {
        m_kept = std::exchange(m_unkept, {});
        for (const auto& [object, event] : m_kept)
            job.actions.push_back(event);
        m_nextKeep = now + kKeepInterval;
    }
    const bool isAwaited = !job.facts.empty() || !m_tokens.empty();
    if (m_access->isUnwritten() && (isAwaited || now >= m_nextSecrets))
        job.beside = m_access->handOver();
    if (!isAwaited && job.actions.empty() && !job.beside && now < m_nextWatch)
        return;
    m_nextWatch = now + kWatchInterval;
    m_tokensHandedOver = std::exchange(m_tokens, {});
    m_handedOverAt = now;
    m_writer->write(std::move(job));
}

void HostDriver::waitForDisk(LocalTime now)
{
    if (m_writer->isBusy())
        take(m_writer->wait(), now); // what is under way
    m_nextKeep = std::min(m_nextKeep, now);
    m_nextSecrets = std::min(m_nextSecrets, now);
    handOver(now);
    if (m_writer->isBusy())
        take(m_writer->wait(), now); // what was left
}

void HostDriver::takeReport(LocalTime now)
{
    if (const auto report = m_writer->take())
        take(*report, now);
}

void HostDriver::take(const StoreReport& report, LocalTime now)
{
    const std::size_t facts = m_ledger.takeHandedOver();
    if (facts > 0)
        m_storing = std::min(now - m_handedOverAt, kLongestStoring);
    Datagrams tokens = std::exchange(m_tokensHandedOver, {}); // lost ones are asked for again
    if (report.facts) {
        m_access->stored();
        m_board.setJoinCodes(m_access->codes());
        stored(facts, now);
        std::ranges::move(tokens, std::back_inserter(m_tokensStored));
    } else {
        giveUp(report.facts.error(), now);
    }
    if (!report.actions)
        keepAgain(report.actions.error(), now);
    m_kept.clear();
    takeMoved(report.moved);
}

void HostDriver::keepAgain(const Error& why, LocalTime now)
{
    m_refusal = why;
    m_unkept.merge(m_kept); // those of which no newer one came meanwhile
    m_nextKeep = now + kWatchInterval;
}

void HostDriver::takeMoved(const Result<std::optional<std::filesystem::path>>& moved)
{
    if (moved && !*moved) {
        if (m_storeFault && m_storeFault->code == Errc::StoreFailed)
            m_storeFault.reset(); // it can be written again
        return;
    }
    m_storeFault = moved ? Error{Errc::StoreReplaced, (*moved)->string()} : moved.error();
    if (moved)
        m_access->moveBeside(**moved);
    m_refusal = m_storeFault; // in front of what was told before
}

NodeDriver::Datagrams HostDriver::advance(LocalTime now)
{
    takeReport(now);
    sendOwnStreams(now);
    compareViews(now);
    dismissRemoved(now);
    if (const auto reading = m_externalClock.read(now))
        m_core->readExternal(*reading, now);
    m_core->advance(now);
    dropAbsent(now);
    m_paths.advance(now);
    for (const EventCpo& event : m_core->takeChanged())
        m_unkept.insert_or_assign(event.object, event);
    SyncHost::Output output = m_core->take();
    replaceTokens(output.displaced, now);
    handOver(now);
    for (const StreamSample& sample : output.streams)
        m_board.objects.take(sample, m_core->sessionTime(now));
    for (const ShownPose& shown : output.shown)
        m_views.compare(shown);
    show(now);
    std::ranges::move(output.ended, std::back_inserter(m_ended));
    std::ranges::move(std::exchange(m_tokensStored, {}), std::back_inserter(output.datagrams));
    return std::move(output.datagrams);
}

LocalTime HostDriver::nextWake() const
{
    if (!m_tokensStored.empty())
        return LocalTime::min();
    const LocalTime wake = std::min({m_core->nextWake(), m_publications.nextTick(), m_returnsEnd,
                                     m_nextViews, m_paths.nextWake(), m_hostView.nextWake()});
    if (m_writer->isBusy())
        return wake; // it wakes by its report
    if (m_ledger.unstored() > 0 || !m_tokens.empty())
        return LocalTime::min();
    return std::min({wake, m_nextWatch, m_unkept.empty() ? LocalTime::max() : m_nextKeep,
                     m_access->isUnwritten() ? m_nextSecrets : LocalTime::max()});
}

std::vector<PeerAddress> HostDriver::takeEnded()
{
    std::vector<PeerAddress> ended = m_paths.takeEnded();
    std::ranges::move(std::exchange(m_ended, {}), std::back_inserter(ended));
    return ended;
}

NodeDriver::Datagrams HostDriver::close(LocalTime now)
{
    waitForDisk(now);
    m_core->close(now);
    return std::move(m_core->take().datagrams);
}

std::vector<PathReport> HostDriver::measurePaths(LocalTime now) const
{
    const SessionTime session = m_core->sessionTime(now);
    std::vector<PathReport> paths;
    for (const auto& [address, peer] : m_core->peers()) {
        PathReport path = reportPath(peer.participant, peer.link, peer.clock.trigger(),
                                     m_core->strategyTriggerTo(peer.participant));
        path.traffic = reportTraffic(peer.traffic, now);
        if ((path.clockOffset = peer.clock.offset(session))) {
            path.clockError = fromSeconds(peer.clock.uncertainty(session));
            path.clockErrorBound = peer.clock.bound(session);
            path.external = peer.clock.external();
        }
        paths.push_back(std::move(path));
    }
    return paths;
}

void HostDriver::show(LocalTime now)
{
    NodeBoard::View view = m_hostView.at(now, m_ledger, *m_core);
    view.self = kSelf;
    m_board.showActions(view, m_core->actions());
    view.drifts = m_views.drifts();
    m_board.showPaths(view, now, [&] { return measurePaths(now); });
    view.refusal = m_refusal ? m_refusal : m_storeFault ? m_storeFault : m_access->fault();
    if (m_board.show(std::move(view)))
        m_board.announce();
}

void HostDriver::connected(PeerAddress peer, const Credential& who, LocalTime now)
{
    m_access->connected(peer, who);
    m_paths.connected(peer, who, std::exchange(m_source, {}), now);
}

void HostDriver::disconnected(PeerAddress peer, LocalTime now)
{
    m_access->disconnected(peer);
    m_paths.disconnected(peer);
    m_core->drop(peer, now);
}

void HostDriver::refused(const Error& why, LocalTime) { m_refusal = why; }

void HostDriver::receive(PeerAddress from, std::span<const std::byte> bytes, LocalTime now)
{
    if (!m_paths.hears(from, now))
        return;
    compareViews(now); // by what was known until now
    if (!isTokenRequest(bytes)) {
        m_speaker = from;
        m_core->receive(from, bytes, now);
        return;
    }
    const auto peer = m_core->peers().find(from);
    if (peer == m_core->peers().end() || !m_core->takesDatagram(from, bytes.size(), now)
        || !m_paths.hearsTokenRequest(from, now))
        return;
    // Who is banned gets none, though it has not been told so yet.
    const auto& participants = m_ledger.decided().state().participants();
    if (const auto known = participants.find(peer->second.participant);
        known != participants.end() && known->second.removal)
        return;
    // Without a token the peer comes back by its code.
    if (const auto token = m_access->issueToken(from, peer->second.participant))
        m_tokens.push_back({from, encodeToken({peer->second.participant, *token})});
}

Result<void> HostDriver::prepare(const Fact& fact)
{
    // Neither an old code nor the token of one who is banned must outlive the fact that it is void:
    // the secrets are written before the fact.
    if (const auto* changed = std::get_if<fact::RoleCodeChanged>(&fact.body)) {
        // Each code costs a second of processor time for its key.
        if (m_access->isDeriving(changed->role))
            return fail(Errc::TooMuchSent);
        m_access->changeCode(changed->role);
    }
    const auto* removed = std::get_if<fact::ParticipantRemoved>(&fact.body);
    if (removed && removed->banned)
        m_access->revokeToken(
            m_ledger.decided().state().participants().at(removed->participant).role,
            removed->participant);
    return {};
}

void HostDriver::carryOut(const FactBody& body)
{
    if (const auto* removed = std::get_if<fact::ParticipantRemoved>(&body))
        m_removed.push_back(removed->participant);
}

Result<void> HostDriver::revokeBanned() const
{
    for (const auto& [id, participant] : m_ledger.stored().state().participants())
        if (participant.removal && participant.removal->banned)
            m_access->revokeToken(participant.role, id);
    return m_access->isUnwritten() ? m_access->write() : Result<void>{};
}

void HostDriver::dismissRemoved(LocalTime now)
{
    for (const ParticipantId id : std::exchange(m_removed, {})) {
        const auto& removal = m_ledger.stored().state().participants().at(id).removal;
        if (!removal)
            continue; // back already
        m_core->dismiss(id, removalError(m_ledger.stored().state(), *removal), now);
    }
}

void HostDriver::replaceTokens(const std::vector<SyncHost::Output::Displaced>& displaced,
                               LocalTime now)
{
    for (const auto& [old, participant] : displaced) {
        m_access->displace(old);
        const Role role = m_ledger.stored().state().participants().at(participant).role;
        std::optional<PeerAddress> keeper;
        for (const auto& [address, peer] : m_core->peers())
            if (peer.participant == participant)
                keeper = address;
        const AccessKey token = m_access->replaceToken(role, participant, keeper);
        static_cast<void>(decideByHost(kNoStation, fact::TokenReplaced{participant}, now));
        if (keeper)
            m_tokens.push_back({*keeper, encodeToken({participant, token})});
    }
}

void HostDriver::left(ParticipantId participant, Leave why, LocalTime now)
{
    const FactBody body = why == Leave::Silence ? FactBody{fact::ParticipantFellSilent{participant}}
                                                : FactBody{fact::ParticipantLeft{participant}};
    // What is refused is shown as the node's refusal; the participant is gone all the same.
    static_cast<void>(decideByHost(kNoStation, body, now));
}

void HostDriver::dropAbsent(LocalTime now)
{
    if (now < m_returnsEnd)
        return;
    m_returnsEnd = LocalTime::max();
    std::vector<ParticipantId> absent;
    for (const auto& [id, participant] : m_ledger.decided().state().participants())
        if (participant.present && id != kSelf && !m_core->isHere(id))
            absent.push_back(id);
    for (const ParticipantId id : absent)
        left(id, Leave::Meant, now); // whether they wanted to come back nobody knows
}

} // namespace carina
