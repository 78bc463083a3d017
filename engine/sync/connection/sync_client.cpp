#include "engine/sync/connection/sync_client.h"

#include "engine/sync/wire/datagram_codec.h"

#include <algorithm>

namespace carina
{
namespace
{

// Leaves room for header and acknowledgement, so that all proposals sent at once share a datagram.
constexpr std::size_t kProposalBytes = 1100;

constexpr int kGoodbyes = 3;
/// Reasons after which a program comes back only when a person wants it to.
bool isForGood(Errc reason)
{
    return reason == Errc::Removed || reason == Errc::Banned || reason == Errc::UsedElsewhere;
}

} // namespace

/// Handles each kind of record at a client; kinds that only the host receives are ignored.
struct SyncClient::Visitor {
    SyncClient& client;
    LocalTime now;

    void operator()(const Welcome& welcome) const { client.welcomed(welcome, now); }
    void operator()(const HelloRefused& refused) const
    {
        if (isForGood(refused.reason))
            client.m_state = State::Closed;
        else if (client.m_state == State::Connected)
            client.reconnect(now);
        client.m_helloRefused = Error{refused.reason, refused.detail};
    }
    void operator()(const ConnectionUnknown&) const
    {
        if (client.m_state == State::Connected)
            client.reconnect(now);
    }
    void operator()(const Goodbye&) const
    {
        if (client.m_state == State::Connected)
            client.reconnect(now);
    }
    void operator()(const FactRecord& fact) const
    {
        if (client.m_state == State::Connected)
            client.takeFact(fact, now);
    }
    void operator()(const ProposalRefused& refused) const
    {
        if (auto proposal = client.m_proposals.settle(refused.proposal))
            client.m_output.refused.push_back({*std::move(proposal), refused.reason});
    }
    void operator()(const StreamGroup& group) const
    {
        if (client.m_state == State::Connected)
            client.takeStreams(group, now);
    }
    void operator()(const EventCpo& event) const { take(event); }
    void operator()(const EventBeat& beat) const { take(beat); }
    void operator()(const ExternalTimeRecord& host) const
    {
        if (client.m_state == State::Connected && client.m_external)
            client.m_clock.setExternal(
                externalOffset(host.time, *client.m_external, now - client.m_externalRead, now));
    }
    void operator()(const EventAck& ack) const { client.m_actions.acknowledge(ack); }
    void operator()(const StrategyMessage& message) const
    {
        if (client.m_state == State::Connected)
            client.m_actions.take(message, now);
    }
    void operator()(const ShownPose& shown) const
    {
        if (client.m_state == State::Connected)
            client.m_output.shown.push_back(shown);
    }
    void operator()(const LagNeeded& needed) const { client.m_actions.setNeededLag(needed.lag); }
    template <class Other> void operator()(const Other&) const {}

    void take(const auto& action) const
    {
        if (client.m_state == State::Connected)
            client.m_actions.take(action, client.sessionTime(now), now);
    }
};

SyncClient::SyncClient(ProposalRecord join, std::uint32_t firstConnection, LocalTime now,
                       std::string station)
    : m_join{std::move(join)},
      m_station{std::move(station)},
      m_link{firstConnection, Duration{}, now},
      m_nextHello{now}
{
}

void SyncClient::receive(std::span<const std::byte> bytes, LocalTime now)
{
    const auto datagram = decodeDatagram(bytes);
    if (!datagram && datagram.error().code == Errc::VersionMismatch && m_state != State::Connected)
        m_helloRefused = Error{Errc::VersionMismatch, {}};
    if (!datagram || m_state == State::Closed || !datagram->header.fromHost
        || datagram->header.connection != m_link.connection())
        return;
    const auto trip = m_link.heard(datagram->header, now);
    for (const WireRecord& record : datagram->records)
        std::visit(Visitor{*this, now}, record);
    if (trip && m_state == State::Connected)
        addProbe(*trip, now);
}

void SyncClient::advance(LocalTime now)
{
    if (m_state == State::Connected && now >= m_link.lastHeard() + kPeerTimeout)
        reconnect(now);
    if (m_state == State::Connected)
        sendDue(now);
    else if (m_state != State::Closed && now >= m_nextHello)
        sendHello(now);
}

LocalTime SyncClient::nextWake() const
{
    if (m_state == State::Closed)
        return LocalTime::max();
    if (m_state != State::Connected)
        return m_nextHello;
    return std::min({m_link.lastHeard() + kPeerTimeout, m_link.lastSent() + keepAlive(),
                     m_acknowledgement.due(), m_proposals.nextDue(), m_actions.nextDue(),
                     m_outgoing.empty() ? LocalTime::max() : m_tick.next(),
                     m_shown.empty() ? LocalTime::max() : LocalTime::min()});
}

void SyncClient::propose(ProposalRecord proposal, LocalTime now)
{
    m_proposals.add(std::move(proposal), now);
}

void SyncClient::share(ObjectId object, const Ownership& ownership)
{
    m_table.share(object, ownership.owner);
    m_actions.share(object, ownership);
}

Result<void> SyncClient::act(ObjectId object, const ObjectAction& action, LocalTime now)
{
    const auto session = sessionTime(now);
    if (!session)
        return fail(Errc::NotPermitted, "the session's clock is not set yet");
    return m_actions.act(object, action, *session, now);
}

void SyncClient::publish(StationId station, const StreamCpo& cpo)
{
    if (m_state == State::Connected)
        m_outgoing.insert_or_assign(cpo.object, StreamSample{m_self, m_epoch, station, cpo});
}

void SyncClient::greetNow(LocalTime now)
{
    m_nextHello = now;
    m_helloWait = kFirstHelloWait;
}

void SyncClient::leave(LocalTime now)
{
    // Nobody is there to repeat one that is lost, and who leaves would be missed.
    for (int i = 0; m_state == State::Connected && i < kGoodbyes; ++i)
        send(std::array<WireRecord, 1>{Goodbye{}}, false, now);
    m_state = State::Closed;
}

bool SyncClient::isCaughtUp() const
{
    return m_state == State::Connected && m_facts.last() >= m_logAtWelcome;
}

void SyncClient::welcomed(const Welcome& welcome, LocalTime now)
{
    if (m_state == State::Connected)
        return;
    if (m_session != SessionKey{}
        && (welcome.session != m_session || welcome.lastFact < m_facts.last()))
        startAfresh();
    m_state = State::Connected;
    m_helloRefused.reset();
    m_station.clear();
    m_session = welcome.session;
    m_self = welcome.participant;
    m_actions.setSelf(m_self);
    m_actions.connected(sessionTime(now), now);
    m_epoch = welcome.epoch;
    m_logAtWelcome = welcome.lastFact;
    m_helloWait = kFirstHelloWait;
    m_proposals.repeatAt(now);
    m_clock.reacquire();
}

void SyncClient::startAfresh()
{
    m_facts = {};
    m_proposals.clear();
    m_table.clear();
    m_clock = {};
    m_actions.startAfresh();
    m_output.facts.clear();
    m_output.streams.clear();
    m_output.shown.clear();
    m_output.startedAfresh = true;
}

void SyncClient::reconnect(LocalTime now)
{
    m_state = State::Away;
    m_link = PeerLink{m_link.connection() + 1, Duration{}, now};
    m_nextHello = now;
    m_outgoing.clear();
    m_shown.clear();
    m_actions.disconnected(now);
    m_acknowledgement.given();
}

void SyncClient::takeFact(const FactRecord& fact, LocalTime now)
{
    std::vector<FactRecord> inOrder = m_facts.take(fact);
    m_acknowledgement.arrived(inOrder.size(), now);
    for (FactRecord& next : inOrder) {
        m_proposals.settle(next.proposal);
        m_output.facts.push_back(std::move(next));
    }
}

void SyncClient::takeStreams(const StreamGroup& group, LocalTime now)
{
    const auto session = sessionTime(now);
    if (!session)
        return;
    for (const StreamCpo& cpo : group.streams) {
        const StreamSample sample{group.owner, group.epoch, group.station, cpo};
        if (group.owner != m_self && m_table.accept(sample, *session))
            m_output.streams.push_back(sample);
    }
}

std::optional<SessionTime> SyncClient::sessionTime(LocalTime t) const
{
    return m_clock.mapping() ? std::optional{m_clock.mapping()->at(t)} : std::nullopt;
}

void SyncClient::addProbe(const RoundTrip& trip, LocalTime now)
{
    m_clock.addProbe(
        {trip.sent, SessionTime{trip.peerSent - trip.hold}, SessionTime{trip.peerSent}, now});
}

void SyncClient::sendHello(LocalTime now)
{
    send(std::array<WireRecord, 1>{Hello{m_session, m_facts.last(), m_join, m_station}}, false,
         now);
    m_nextHello = now + m_helloWait;
    m_helloWait = std::min(2 * m_helloWait, kLastHelloWait);
}

void SyncClient::sendDue(LocalTime now)
{
    std::vector<WireRecord> records;
    for (ProposalRecord& proposal : m_proposals.takeDue(kProposalBytes, now))
        records.emplace_back(std::move(proposal));
    std::ranges::move(m_actions.takeDue(now), std::back_inserter(records));
    std::ranges::move(dueStreams(now), std::back_inserter(records));
    std::ranges::copy(std::exchange(m_shown, {}), std::back_inserter(records));
    if (m_acknowledgement.due() <= now || (m_acknowledgement.isOwed() && !records.empty())) {
        records.emplace_back(FactAck{m_facts.last()});
        m_acknowledgement.given();
    }
    const bool isProbe = records.empty();
    if (isProbe && now < m_link.lastSent() + keepAlive())
        return;
    // With what goes anyway, so that no probe is put off for it.
    if (std::exchange(m_tellExternal, false))
        records.emplace_back(ExternalTimeRecord{*m_external});
    send(records, isProbe, now);
}

std::vector<WireRecord> SyncClient::dueStreams(LocalTime now)
{
    std::vector<WireRecord> records;
    if (m_outgoing.empty() || !m_tick.isDue(now))
        return records;
    std::vector<StreamSample> samples;
    for (const auto& [object, sample] : std::exchange(m_outgoing, {}))
        samples.push_back(sample);
    for (StreamGroup& group : groupStreams(samples))
        records.emplace_back(std::move(group));
    m_tick.served(now);
    return records;
}

void SyncClient::send(std::span<const WireRecord> records, bool isProbe, LocalTime now)
{
    const auto header = [&] {
        BundleHeader next = m_link.nextHeader(now);
        next.sender = m_self;
        next.answerNow = m_state == State::Connected && (m_clock.isAcquiring() || isProbe);
        return next;
    };
    std::ranges::move(packDatagrams(records, header), std::back_inserter(m_output.datagrams));
}

Duration SyncClient::keepAlive() const
{
    return m_clock.isAcquiring() ? kAcquireInterval : std::min(m_clock.idleInterval(), kKeepAlive);
}

} // namespace carina
