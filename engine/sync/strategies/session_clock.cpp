#include "engine/sync/actions/event_table.h"
#include "engine/sync/clock/fitted_clock.h"
#include "engine/sync/connection/peer_link.h"
#include "engine/sync/strategies/session_clock_host.h"
#include "engine/sync/strategies/strategies.h"
#include "engine/sync/wire/datagram_codec.h"

#include <algorithm>

namespace carina
{
namespace
{

/// Everybody dates what happens on one session clock, the host's, and evaluates it for the session
/// time that is drawn. The clock is measured with the headers of the datagrams that go anyway; an
/// idle participant probes by the adaptive rule.
class SessionClockParticipant final : public StarParticipant
{
public:
    /// Between probes while the clock is being set.
    static constexpr Duration kAcquireInterval = std::chrono::milliseconds{20};

    SessionClockParticipant(const StarSeat& seat, LocalTime now)
        : m_self{seat.self}, m_link{seat.self.value, Duration{}, now}
    {
    }

    void receive(ParticipantId, std::span<const std::byte> bytes, LocalTime now) override
    {
        const auto datagram = decodeDatagram(bytes);
        if (!datagram || !datagram->header.fromHost)
            return;
        if (const auto trip = m_link.heard(datagram->header, now)) {
            const SessionTime sent{trip->peerSent};
            m_clock.addProbe({trip->sent, sent - trip->hold, sent, now});
            stampWaiting(now);
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
        m_own.insert_or_assign(action.object, Own{action, now});
        stampWaiting(now);
    }

    void advance(LocalTime now) override
    {
        std::vector<WireRecord> records = std::exchange(m_acks, {});
        for (const DueEvent& due : m_repeater.takeDue(now))
            records.push_back(due.record());
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
        return std::min(nextProbe(), m_repeater.nextDue());
    }

    [[nodiscard]] std::optional<ShownObject> shown(ObjectId object, LocalTime t) const override
    {
        if (const auto own = m_own.find(object); own != m_own.end())
            return ShownObject{evaluateAfter(own->second.action, t - own->second.begun)};
        const auto session = sessionTime(t);
        if (!session)
            return std::nullopt;
        if (const auto acted = m_table.at(object, *session))
            return ShownObject{*acted, m_table.isStale(object, t)};
        return std::nullopt;
    }

    [[nodiscard]] std::optional<SessionTime> sessionTime(LocalTime t) const override
    {
        if (!m_clock.mapping())
            return std::nullopt;
        return m_clock.mapping()->at(t);
    }

    [[nodiscard]] std::uint64_t probesSent() const override { return m_probes; }

private:
    struct Own {
        EventCpo action;
        LocalTime begun;
        bool isStamped = false;
    };

    void take(const EventCpo& event, LocalTime now)
    {
        if (m_table.take(event, sessionTime(now), now) != EventTable::Verdict::Refused)
            m_acks.emplace_back(EventAck{event.object, event.epoch, event.action});
    }

    void take(const WireRecord& record, LocalTime now)
    {
        if (const auto* event = std::get_if<EventCpo>(&record)) {
            take(*event, now);
        } else if (const auto* beat = std::get_if<EventBeat>(&record)) {
            if (const EventCpo* known = m_table.named(*beat))
                take(EventCpo{*known}, now);
        } else if (const auto* ack = std::get_if<EventAck>(&record)) {
            m_repeater.acknowledge(*ack);
        } else if (const auto* host = std::get_if<ExternalTimeRecord>(&record)) {
            if (m_external)
                m_clock.setExternal(
                    externalOffset(host->time, *m_external, now - m_externalRead, now));
        }
    }

    /// Dates own actions as soon as the clock is set, and sends them.
    void stampWaiting(LocalTime now)
    {
        if (!m_clock.mapping())
            return;
        for (auto& [object, own] : m_own) {
            if (own.isStamped)
                continue;
            own.action.start = m_clock.mapping()->at(own.begun);
            own.isStamped = true;
            m_repeater.begin(own.action, now);
        }
    }

    [[nodiscard]] LocalTime nextProbe() const
    {
        return m_link.lastSent()
               + (m_clock.isAcquiring() ? kAcquireInterval : m_clock.idleInterval());
    }

    ParticipantId m_self;
    PeerLink m_link;
    FittedClock m_clock;
    std::optional<ExternalTime> m_external;
    LocalTime m_externalRead{};
    EventTable m_table;
    EventRepeater m_repeater{true};
    std::map<ObjectId, Own> m_own;
    std::vector<WireRecord> m_acks;
    std::uint64_t m_probes = 0;
};

} // namespace

SyncStrategy sessionClockStrategy()
{
    return {"session-clock", "everything dated on one clock, repeated until it has arrived",
            SessionClockHost::make,
            [](const StarSeat& seat, LocalTime now) -> std::unique_ptr<StarParticipant> {
                return std::make_unique<SessionClockParticipant>(seat, now);
            }};
}

} // namespace carina
