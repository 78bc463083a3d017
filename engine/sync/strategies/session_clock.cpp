#include "engine/sync/actions/client_actions.h"
#include "engine/sync/clock/fitted_clock.h"
#include "engine/sync/connection/peer_link.h"
#include "engine/sync/strategies/session_clock_host.h"
#include "engine/sync/strategies/strategies.h"
#include "engine/sync/wire/datagram_codec.h"

#include <algorithm>
#include <map>

namespace carina
{
namespace
{

/// Everybody dates what happens on one session clock, the host's, and evaluates it for the session
/// time that is drawn. The clock is measured with the headers of the datagrams that go anyway; an
/// idle participant probes by the adaptive rule.
///
/// With local lag an action begins later than the actor asked for, by the delay to the farthest
/// participant or a bound, so that it has arrived everywhere when it begins. A session counts those
/// participants who may act: who only watches cannot slow them.
class SessionClockParticipant final : public StarParticipant
{
public:
    /// Between probes while the clock is being set.
    static constexpr Duration kAcquireInterval = std::chrono::milliseconds{20};

    SessionClockParticipant(const StarSeat& seat, const StrategyChoice& choice, LocalTime now)
        : m_self{seat.self},
          m_hasLag{choice.kind == StrategyKind::LocalLag},
          m_link{seat.self.value, Duration{}, now}
    {
        m_actions.setSelf(seat.self);
        m_actions.setStrategy(choice, now);
    }

    void receive(ParticipantId, std::span<const std::byte> bytes, LocalTime now) override
    {
        const auto datagram = decodeDatagram(bytes);
        if (!datagram || !datagram->header.fromHost)
            return;
        if (const auto trip = m_link.heard(datagram->header, now)) {
            const SessionTime sent{trip->peerSent};
            m_clock.addProbe({trip->sent, sent - trip->hold, sent, now});
            beginWaiting(now);
        }
        for (const WireRecord& record : datagram->records)
            take(record, now);
    }

    void readExternal(const ExternalTime& reading, LocalTime now) override
    {
        m_external = reading;
        m_externalRead = now;
    }

    void act(const EventCpo& action, LocalTime now) override
    {
        m_actions.share(action.object, {m_self, action.epoch});
        m_waiting.insert_or_assign(action.object, Waiting{action, now});
        beginWaiting(now);
    }

    void forget(ObjectId object) override { m_waiting.erase(object); }

    void advance(LocalTime now) override
    {
        const std::vector<WireRecord> records = m_actions.takeDue(now);
        const bool isProbe = records.empty();
        if (isProbe && now < nextProbe())
            return;
        if (isProbe)
            ++m_probes;
        const auto nextHeader = [&] {
            BundleHeader header = m_link.nextHeader(now);
            header.sender = m_self;
            header.answerNow = isProbe;
            return header;
        };
        for (auto& bytes : packDatagrams(records, nextHeader))
            send(kStarHost, std::move(bytes));
    }

    [[nodiscard]] LocalTime nextWake() const override
    {
        return std::min(nextProbe(), m_actions.nextDue());
    }

    [[nodiscard]] std::optional<ShownObject> shown(ObjectId object, LocalTime t) const override
    {
        if (const auto waiting = m_waiting.find(object); waiting != m_waiting.end())
            return ShownObject{evaluateAfter(waiting->second.action, t - waiting->second.begun)};
        const auto session = sessionTime(t);
        return session ? m_actions.shared().shown(object, *session, t, t) : std::nullopt;
    }

    [[nodiscard]] std::optional<SessionTime> sessionTime(LocalTime t) const override
    {
        if (!m_clock.mapping())
            return std::nullopt;
        return m_clock.mapping()->at(t);
    }

    [[nodiscard]] std::uint64_t probesSent() const override { return m_probes; }

private:
    struct Waiting {
        EventCpo action;
        LocalTime begun;
    };

    void take(const WireRecord& record, LocalTime now)
    {
        if (const auto* event = std::get_if<EventCpo>(&record))
            m_actions.take(*event, sessionTime(now), now);
        else if (const auto* beat = std::get_if<EventBeat>(&record))
            m_actions.take(*beat, sessionTime(now), now);
        else if (const auto* ack = std::get_if<EventAck>(&record))
            m_actions.acknowledge(*ack);
        else if (const auto* needed = std::get_if<LagNeeded>(&record))
            m_actions.setNeededLag(needed->lag);
        else if (const auto* host = std::get_if<ExternalTimeRecord>(&record); host && m_external)
            m_clock.setExternal(externalOffset(host->time, *m_external, now - m_externalRead, now));
    }

    /// Begins own actions as soon as the clock is set.
    void beginWaiting(LocalTime now)
    {
        if (!m_clock.mapping())
            return;
        for (const auto& [object, waiting] : std::exchange(m_waiting, {})) {
            const EventCpo& action = waiting.action;
            const ObjectAction own{action.kind, action.axis_A.cast<double>(), double{action.rate},
                                   evaluateAfter(action, Duration{}), !m_hasLag};
            static_cast<void>(
                m_actions.act(object, own, m_clock.mapping()->at(waiting.begun), now));
        }
    }

    [[nodiscard]] LocalTime nextProbe() const
    {
        return m_link.lastSent()
               + (m_clock.isAcquiring() ? kAcquireInterval : m_clock.idleInterval());
    }

    ParticipantId m_self;
    bool m_hasLag; // then it begins from where the object is by that time
    PeerLink m_link;
    FittedClock m_clock;
    std::optional<ExternalTime> m_external;
    LocalTime m_externalRead{};
    ClientActions m_actions;
    std::map<ObjectId, Waiting> m_waiting;
    std::uint64_t m_probes = 0;
};

} // namespace

SyncStrategy sessionClockStrategy()
{
    return {StrategyKind::SessionClock, "session-clock",
            "everything dated on one clock, repeated until it has arrived", SessionClockHost::make,
            [](const StarSeat& seat, const StrategyChoice&,
               LocalTime now) -> std::unique_ptr<StarParticipant> {
                return std::make_unique<SessionClockParticipant>(seat, StrategyChoice{}, now);
            }};
}

SyncStrategy localLagStrategy()
{
    return {
        StrategyKind::LocalLag, "local-lag",
        "as session-clock, but an action begins later, with its actor too: when it has arrived, or "
        "after a bound",
        SessionClockHost::makeWithLag,
        [](const StarSeat& seat, const StrategyChoice& choice,
           LocalTime now) -> std::unique_ptr<StarParticipant> {
            StrategyChoice withLag = choice;
            withLag.kind = StrategyKind::LocalLag;
            return std::make_unique<SessionClockParticipant>(seat, withLag, now);
        }};
}

} // namespace carina
