#include "engine/sync/connection/sync_host.h"

#include "engine/core/expects.h"
#include "engine/sync/strategies/relayed_message.h"
#include "engine/sync/wire/datagram_codec.h"
#include "engine/sync/wire/sequence.h"

#include <algorithm>

namespace carina
{
namespace
{

constexpr ParticipantId kHost{0};

/// As much of a text as a record takes, and whole characters of it.
std::string shortened(const std::string& utf8)
{
    std::size_t length = std::min(utf8.size(), kLongestDetail);
    while (length > 0 && length < utf8.size() && (utf8[length] & 0xC0) == 0x80)
        --length;
    return utf8.substr(0, length);
}

/// What is behind a refusal is told only to whom it concerns.
HelloRefused refusalOf(const Error& why)
{
    const bool concernsThem =
        why.code == Errc::Removed || why.code == Errc::Banned || why.code == Errc::StationUnknown;
    return {why.code, concernsThem ? shortened(why.detail) : std::string{}};
}

Duration roundTripOf(const PeerLink& link) { return link.longestRoundTrip().value_or(Duration{}); }

} // namespace

/// Handles each kind of record at the host; kinds that only a client receives are ignored.
struct SyncHost::Visitor {
    SyncHost& host;
    PeerAddress from;
    Peer& peer;
    LocalTime now;

    void operator()(const ProposalRecord& proposal) const { host.propose(peer, proposal, now); }
    void operator()(const FactAck& ack) const
    {
        peer.facts.acknowledge(ack.last, roundTripOf(peer.link), now);
    }
    void operator()(const StreamGroup& group) const { host.takeStreams(peer, group, now); }
    void operator()(const EventCpo& event) const { take(event); }
    void operator()(const EventBeat& beat) const { take(beat); }
    void operator()(const EventAck& ack) const { host.m_actions.acknowledge(from, ack); }
    void operator()(const ShownPose& shown) const
    {
        if (host.m_actions.shared().ownerOf(shown.object) == peer.participant
            && host.m_rules.mayAct(peer.participant) && peer.budget.takesMessage(now))
            host.m_shown.take(shown, peer.participant, now);
    }
    void operator()(const StrategyMessage& message) const
    {
        const auto relayed = decodeRelayed(message.bytes);
        if (!relayed)
            return;
        const bool isAnswer = std::holds_alternative<DelayAnswer>(relayed->content);
        const bool mayAct = host.m_rules.mayAct(peer.participant);
        if (isAnswer ? !peer.budget.takesProbeAnswer(now) : !peer.budget.takesMessage(now))
            return;
        host.m_actions.take(from, *relayed, message, mayAct, now);
    }
    void operator()(const ExternalTimeRecord& own) const
    {
        if (host.m_external)
            peer.clock.setExternal(*host.m_external, own.time, now - host.m_externalRead);
    }
    template <class Other> void operator()(const Other&) const {}

    void take(const auto& action) const
    {
        if (host.m_rules.mayAct(peer.participant) && peer.budget.takesEvent(now))
            host.m_actions.take(from, action, host.sessionTime(now), now);
    }
};

SyncHost::SyncHost(const SessionKey& session, std::vector<FactRecord> log, Duration clockOffset,
                   HostRules rules)
    : m_session{session},
      m_log{std::move(log)},
      m_clockOffset{clockOffset},
      m_rules{std::move(rules)}
{
}

void SyncHost::receive(PeerAddress from, std::span<const std::byte> bytes, LocalTime now)
{
    if (m_peers.contains(from) && !takesDatagram(from, bytes.size(), now))
        return;
    take(from, bytes, now);
    if (const auto peer = m_peers.find(from);
        peer != m_peers.end() && peer->second.budget.isFarExceeded())
        m_exceeding.insert(from);
}

bool SyncHost::takesDatagram(PeerAddress from, std::size_t bytes, LocalTime now)
{
    const auto found = m_peers.find(from);
    if (found == m_peers.end())
        return false;
    Peer& peer = found->second;
    peer.traffic.bytes.add(double(bytes), now);
    const bool taken = peer.budget.takesDatagram(bytes, now);
    peer.traffic.refused += taken ? 0 : 1;
    if (peer.budget.isFarExceeded())
        m_exceeding.insert(from);
    return taken;
}

void SyncHost::take(PeerAddress from, std::span<const std::byte> bytes, LocalTime now)
{
    const auto found = m_peers.find(from);
    const auto datagram = decodeDatagram(bytes);
    if (!datagram) {
        if (datagram.error().code == Errc::VersionMismatch)
            answerStranger(from, 0, HelloRefused{Errc::VersionMismatch, {}}, now);
        return;
    }
    const BundleHeader& header = datagram->header;
    if (header.fromHost)
        return;
    for (const WireRecord& record : datagram->records)
        if (const auto* greeting = std::get_if<Hello>(&record))
            return hello(from, header, *greeting, now);

    const bool leaves = std::ranges::any_of(datagram->records, [](const WireRecord& record) {
        return std::holds_alternative<Goodbye>(record);
    });
    if (found == m_peers.end() || found->second.link.connection() != header.connection) {
        if (!leaves)
            answerStranger(from, header.connection, ConnectionUnknown{}, now);
        return;
    }
    if (leaves)
        return remove(from, Leave::Meant, now);
    Peer& peer = found->second;
    peer.heard(header, sessionTime(now), now);
    // The lag with which actions begin is for those who act.
    m_actions.measured(from,
                       m_rules.mayAct(peer.participant) ? roundTripOf(peer.link) / 2 : Duration{});
    peer.answer = peer.answer || header.answerNow;
    for (const WireRecord& record : datagram->records)
        std::visit(Visitor{*this, from, peer, now}, record);
}

void SyncHost::readExternal(const ExternalTime& reading, LocalTime now)
{
    m_external = {reading.offset - m_clockOffset, reading.error};
    m_externalRead = now;
    for (auto& [address, peer] : m_peers)
        peer.outbox.emplace_back(ExternalTimeRecord{*m_external});
}

void SyncHost::advance(LocalTime now)
{
    welcomeArrivals(now);
    dropSilentPeers(now);
    endExceedingPeers(now);
    m_actions.advance(sessionTime(now), now);
    relayShown(now);
    serve(now);
}

void SyncHost::serve(LocalTime now)
{
    m_actions.setLongestWait(longestWait());
    if (waitsForTicks() && now < m_streams.nextTick())
        return serveBetween(now);
    m_behind = countBehind();
    const bool tick = m_streams.isDue(now);
    const bool isForAnybody = tick || m_actions.nextDue() <= now;
    if (tick)
        gatherStreams(now);
    for (auto& [address, peer] : m_peers)
        if (isForAnybody || nextDueTo(peer) <= now)
            sendDue(address, peer, tick, now);
    if (tick || waitsForTicks())
        m_streams.served(now);
}

void SyncHost::serveBetween(LocalTime now)
{
    if (!fewCatchUp())
        return;
    for (auto& [address, peer] : m_peers)
        if (catchesUp(peer) && nextDueTo(peer) <= now)
            sendDue(address, peer, false, now);
}

std::size_t SyncHost::countBehind() const
{
    return static_cast<std::size_t>(std::ranges::count_if(
        m_peers, [this](const auto& entry) { return isBehind(entry.second); }));
}

bool SyncHost::maySendLog(Peer& peer, std::size_t bytes, bool isBehind, LocalTime now) const
{
    const double perSecond =
        kCatchUpBytes / static_cast<double>(std::max<std::size_t>(1, m_behind));
    const auto size = static_cast<double>(bytes);
    if (isBehind && !peer.catchUp.takeOf(kCatchUpBytesAtOnce, size, perSecond, now))
        return false;
    if (peer.budget.takesLog(bytes, now))
        return true;
    if (isBehind)
        peer.catchUp.putBack(size, perSecond);
    return false;
}

LocalTime SyncHost::nextWake() const
{
    if (!m_exceeding.empty() || m_arrivals.stored(logEnd()))
        return LocalTime::min();
    const bool inTicks = waitsForTicks();
    LocalTime wake = inTicks ? m_streams.nextTick()
                             : std::min({m_actions.nextDue(), m_streams.nextDue(),
                                         m_shown.nextDue(), m_nobodySilentBefore});
    if (inTicks && !fewCatchUp())
        return wake;
    for (const auto& [address, peer] : m_peers)
        if (!inTicks || catchesUp(peer))
            wake = std::min(wake, nextDueTo(peer));
    return wake;
}

void SyncHost::relayShown(LocalTime now)
{
    for (const auto& [shown, from] : m_shown.takeDue(now)) {
        m_output.shown.push_back(shown);
        forward(shown, from);
    }
}

void SyncHost::forward(const ShownPose& shown, ParticipantId from)
{
    // Who watches all may have objects at every station; the others have them where they are.
    const StationId where = from == kHost ? kAllStations : watchedBy(from);
    for (auto& [address, peer] : m_peers) {
        const StationId watched = watchedBy(peer.participant);
        const bool isSeen = where == kAllStations || watched == kAllStations || watched == where;
        if (peer.participant != from && isSeen)
            peer.outbox.emplace_back(shown);
    }
}

StationId SyncHost::watchedBy(ParticipantId participant) const
{
    return m_rules.watchesAll(participant) ? kAllStations : m_rules.stationOf(participant);
}

StreamSource SyncHost::sourceOf(const Peer& peer) const
{
    const auto* shared = peer.budget.shared();
    return {{reinterpret_cast<std::uintptr_t>(shared), shared ? kNobody : peer.participant},
            m_rules.comesFirst(peer.participant)};
}

void SyncHost::gatherStreams(LocalTime now)
{
    std::vector<StationId> stations;
    for (const auto& [address, peer] : m_peers)
        stations.push_back(watchedBy(peer.participant));
    m_streams.gather(stations, now);
}

LocalTime SyncHost::nextDueTo(const Peer& peer) const
{
    if (peer.welcome || peer.answer || !peer.outbox.empty())
        return LocalTime::min();
    return std::min(peer.link.lastSent() + kKeepAlive, peer.facts.nextDue(logEnd()));
}

void SyncHost::append(const FactRecord& fact)
{
    CARINA_EXPECTS(fact.number.value == m_log.size() + 1);
    m_log.push_back(fact);
}

void SyncHost::giveUp(const FactRecord& fact, Errc why, LocalTime now)
{
    for (auto& [address, peer] : m_peers)
        if (peer.participant == fact.author)
            peer.outbox.emplace_back(ProposalRefused{fact.proposal, why});
    for (const auto& [address, arrival] : m_arrivals.takeWaitingFor(fact.number))
        answerStranger(address, arrival.header.connection, HelloRefused{why}, now);
}

void SyncHost::share(ObjectId object, const Ownership& ownership)
{
    m_streams.share(object, ownership.owner);
    m_actions.share(object, ownership);
}

void SyncHost::publish(const StreamSample& sample, LocalTime now)
{
    m_streams.take(sample, {{0, kHost}, true}, sessionTime(now));
}

void SyncHost::drop(PeerAddress address, LocalTime now)
{
    m_asksSince.erase(address);
    const auto arriving = m_arrivals.drop(address);
    const auto peer = m_peers.find(address);
    const bool isSame = peer != m_peers.end() && arriving == peer->second.participant;
    if (peer != m_peers.end())
        remove(address, Leave::Silence, now);
    if (arriving && !isSame && !isHere(*arriving))
        m_rules.left(*arriving, Leave::Meant, now); // who was not in yet is not missed
}

bool SyncHost::isHere(ParticipantId participant) const
{
    return std::ranges::any_of(
               m_peers, [&](const auto& entry) { return entry.second.participant == participant; })
           || m_arrivals.isHere(participant);
}

void SyncHost::dismiss(ParticipantId participant, const Error& why, LocalTime now)
{
    for (const auto& [address, peer] : m_peers)
        if (peer.participant == participant)
            answerStranger(address, peer.link.connection(), refusalOf(why), now);
    m_arrivals.forget(participant);
    forgetParticipant(participant, now);
}

void SyncHost::close(LocalTime now)
{
    for (auto& [address, peer] : m_peers) {
        peer.outbox.emplace_back(Goodbye{});
        sendDue(address, peer, false, now);
    }
    m_peers.clear();
    m_exceeding.clear();
}

Duration SyncHost::slowestPath() const
{
    Duration slowest{};
    for (const auto& [address, peer] : m_peers) {
        const Duration longest =
            m_rules.mayAct(peer.participant) ? kLongestPath : kLongestPathOfWatchers;
        slowest = std::max(slowest, std::min(roundTripOf(peer.link) / 2, longest));
    }
    return slowest + longestWait();
}

void SyncHost::hello(PeerAddress from, const BundleHeader& header, const Hello& hello,
                     LocalTime now)
{
    const auto known = m_peers.find(from);
    if (known != m_peers.end() && known->second.join == hello.join.id) {
        Peer& peer = known->second;
        if (peer.link.connection() == header.connection) {
            peer.link.heard(header, now);
            peer.welcome = true; // the first was lost, or this Hello was sent twice
        }
        if (!isAfter(header.connection, peer.link.connection()))
            return;
    }
    if (m_arrivals.hears(from, header, hello, now))
        return;
    const auto admission = admit(from, hello, now);
    if (!admission) {
        if (known == m_peers.end() || known->second.budget.answers(now))
            answerStranger(from, header.connection, refusalOf(admission.error()), now);
        return;
    }
    if (!*admission)
        return;
    m_arrivals.add(from, {header, now, hello, **admission});
}

void SyncHost::welcomeArrivals(LocalTime now)
{
    while (const auto address = m_arrivals.stored(logEnd())) {
        welcome(*address, m_arrivals.at(*address), now);
        m_arrivals.drop(*address);
    }
}

void SyncHost::welcome(PeerAddress address, const Arrival& arrival, LocalTime now)
{
    const auto& [header, heard, hello, admission] = arrival;
    displace(address, admission.participant, now);
    forgetParticipant(admission.participant, now);
    if (m_peers.contains(address))
        remove(address, Leave::Meant, now); // the same program came in as another
    PeerBudget& budget = m_budgets.comesIn(admission.participant, m_rules.limits,
                                           m_rules.sharedBudget(address), now);
    const bool continues = hello.session == m_session && hello.lastFact <= logEnd();
    Peer peer{PeerLink{header.connection, m_clockOffset, now},       admission.participant,
              static_cast<std::uint16_t>(admission.joined.value),    hello.join.id,
              FactSender{continues ? hello.lastFact : FactNumber{}}, budget};
    peer.link.heard(header, heard);
    m_nobodySilentBefore = std::min(m_nobodySilentBefore, heard + kPeerTimeout);
    m_peers.emplace(address, std::move(peer));
    m_behind = countBehind();
    countMembers(now);
    m_actions.join(address, admission.participant, now);
}

Result<std::optional<Admission>> SyncHost::admit(PeerAddress from, const Hello& hello,
                                                 LocalTime now)
{
    const auto who = m_rules.identify(hello, now);
    if (!who)
        return tl::unexpected(who.error());
    if (m_budgets.isBarred(who->participant, now))
        return fail(Errc::TooMuchSent);
    if (who->participant == kHost || isTaken(from, *who, hello.join.id, now))
        return fail(Errc::NameTaken);
    if (PeerBudget* budget = m_budgets.known(who->participant)) {
        switch (budget->takesComing(now)) {
        case PeerBudget::Verdict::Taken:
            break;
        case PeerBudget::Verdict::Later:
            return std::nullopt;
        case PeerBudget::Verdict::Refused:
            return fail(Errc::TooMuchSent);
        }
    }
    return m_rules.admit(hello, now);
}

void SyncHost::countMembers(LocalTime now)
{
    std::map<SharedBudget*, std::size_t> members;
    for (const auto& [address, peer] : m_peers)
        if (SharedBudget* shared = peer.budget.shared())
            ++members[shared];
    for (const auto& [shared, count] : members)
        shared->setMembers(count, now);
}

bool SyncHost::isTaken(PeerAddress from, const Identity& who, ProposalId join, LocalTime now)
{
    for (const auto& [address, peer] : m_peers) {
        const bool isSameRun = who.isProven && peer.join == join;
        if (address == from || peer.participant != who.participant || isSameRun
            || now >= peer.link.lastHeard() + kNameHeld)
            continue;
        const LocalTime since = m_asksSince.try_emplace(from, now).first->second;
        return !who.isProven || peer.link.lastHeard() < since + kAliveBeside;
    }
    return m_arrivals.keepsOut(from, who, join, kNameHeld, now);
}

void SyncHost::displace(PeerAddress from, ParticipantId participant, LocalTime now)
{
    const auto asked = m_asksSince.find(from);
    if (asked == m_asksSince.end())
        return;
    for (const auto& [address, peer] : m_peers) {
        const bool isBeside = address != from && peer.participant == participant
                              && peer.link.lastHeard() >= asked->second + kAliveBeside;
        if (!isBeside)
            continue;
        answerStranger(address, peer.link.connection(), HelloRefused{Errc::UsedElsewhere, {}}, now);
        m_output.displaced.push_back({address, participant});
    }
    m_asksSince.erase(asked);
}

void SyncHost::remove(PeerAddress address, Leave why, LocalTime now)
{
    const auto leaving = m_peers.find(address);
    const ParticipantId participant = leaving->second.participant;
    leaving->second.budget.goes(now);
    m_peers.erase(leaving);
    countMembers(now);
    m_actions.leave(address, now);
    m_streams.leave(participant);
    if (!isHere(participant)) // or it is coming in again
        m_rules.left(participant, why, now);
}

void SyncHost::forgetParticipant(ParticipantId participant, LocalTime now)
{
    for (auto entry = m_peers.begin(); entry != m_peers.end();) {
        const bool isOne = entry->second.participant == participant;
        if (isOne) {
            m_actions.leave(entry->first, now);
            entry->second.budget.goes(now);
        }
        entry = isOne ? m_peers.erase(entry) : std::next(entry);
    }
    m_streams.leave(participant);
    countMembers(now);
}

void SyncHost::propose(Peer& peer, ProposalRecord proposal, LocalTime now)
{
    if (!peer.budget.hearsProposal(now)) {
        ++peer.traffic.refused; // it comes again
        return;
    }
    if (m_rules.isSettled(proposal.id))
        return; // its fact is on its way, to the disk or to everybody
    const auto verdict = peer.budget.takesProposal(now);
    if (verdict == PeerBudget::Verdict::Later)
        return; // it comes again
    if (verdict == PeerBudget::Verdict::Refused) {
        ++peer.traffic.refused;
        if (peer.budget.answers(now))
            peer.outbox.emplace_back(ProposalRefused{proposal.id, Errc::TooMuchSent});
        return;
    }
    proposal.author = peer.participant;
    if (const auto decided = m_rules.decide(proposal, now)) {
        ++peer.traffic.facts;
    } else {
        ++peer.traffic.refused;
        peer.outbox.emplace_back(ProposalRefused{proposal.id, decided.error().code});
    }
}

void SyncHost::takeStreams(Peer& peer, const StreamGroup& group, LocalTime now)
{
    if (group.owner != peer.participant || group.epoch != peer.epoch)
        return;
    peer.traffic.samples.add(double(group.streams.size()), now);
    if (!peer.budget.takesSamples(group.streams.size(), now) || !m_rules.mayAct(peer.participant)
        || group.station != m_rules.stationOf(peer.participant)) {
        peer.traffic.refused += group.streams.size();
        return;
    }
    const SessionTime latest = sessionTime(now) + kLargestAhead
                               + std::min(roundTripOf(peer.link) / 2, kLargestAheadByPath);
    const StreamSource source = sourceOf(peer);
    for (const StreamCpo& cpo : group.streams) {
        if (cpo.time > latest)
            continue;
        const StreamSample sample{group.owner, group.epoch, group.station, cpo};
        if (m_streams.take(sample, source, sessionTime(now)))
            m_output.streams.push_back(sample);
    }
}

void SyncHost::dropSilentPeers(LocalTime now)
{
    if (now < m_nobodySilentBefore)
        return;
    m_nobodySilentBefore = LocalTime::max();
    std::vector<PeerAddress> silent;
    for (const auto& [address, peer] : m_peers) {
        const LocalTime end = peer.link.lastHeard() + kPeerTimeout;
        if (now >= end)
            silent.push_back(address);
        else
            m_nobodySilentBefore = std::min(m_nobodySilentBefore, end);
    }
    for (const PeerAddress address : silent)
        remove(address, Leave::Silence, now);
}

void SyncHost::endExceedingPeers(LocalTime now)
{
    for (const PeerAddress address : std::exchange(m_exceeding, {})) {
        const auto exceeding = m_peers.find(address);
        if (exceeding == m_peers.end())
            continue; // left meanwhile
        const Peer& peer = exceeding->second;
        answerStranger(address, peer.link.connection(), HelloRefused{Errc::TooMuchSent, {}}, now);
        m_output.ended.push_back(address);
        const ParticipantId participant = peer.participant;
        m_arrivals.forget(participant); // or it would come in over another path, barred
        remove(address, Leave::Meant, now);
        m_budgets.bar(participant, now);
    }
}

void SyncHost::sendDue(PeerAddress to, Peer& peer, bool tick, LocalTime now)
{
    std::vector<WireRecord> records;
    if (std::exchange(peer.welcome, false))
        records.emplace_back(Welcome{m_session, peer.participant, peer.epoch, logEnd()});
    std::ranges::move(std::exchange(peer.outbox, {}), std::back_inserter(records));
    std::ranges::move(m_actions.takeDue(to, now), std::back_inserter(records));
    const auto maySend = [&](std::size_t bytes, bool isBehind) {
        return maySendLog(peer, bytes, isBehind, now);
    };
    for (const FactRecord& fact : peer.facts.takeDue(m_log, roundTripOf(peer.link), now, maySend))
        records.emplace_back(fact);
    if (tick)
        std::ranges::move(m_streams.dueTo({peer.participant, watchedBy(peer.participant)}),
                          std::back_inserter(records));
    const bool answer = std::exchange(peer.answer, false);
    if (records.empty() && !answer && now < peer.link.lastSent() + kKeepAlive)
        return;
    const auto header = [&] {
        BundleHeader next = peer.link.nextHeader(now);
        next.fromHost = true;
        next.sender = kHost;
        return next;
    };
    for (auto& bytes : packDatagrams(records, header))
        m_output.datagrams.push_back({to, std::move(bytes)});
}

void SyncHost::answerStranger(PeerAddress to, std::uint32_t connection, const WireRecord& record,
                              LocalTime now)
{
    BundleHeader header;
    header.fromHost = true;
    header.sender = kHost;
    header.connection = connection;
    header.sentAt = sessionTime(now).time_since_epoch();
    const auto datagrams = packDatagrams(std::span{&record, 1}, [&] { return header; });
    m_output.datagrams.push_back({to, datagrams.front()});
}

} // namespace carina
