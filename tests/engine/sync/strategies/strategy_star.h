#pragma once

#include "engine/core/units.h"
#include "engine/sync/strategies/strategy.h"

#include <functional>
#include <map>
#include <memory>
#include <numbers>
#include <vector>

namespace carina::test
{

/// A host and participants over links of constant delay, in virtual time; all clocks are right
/// unless set otherwise.
class StrategyStar
{
public:
    struct Legs {
        Duration toHost = std::chrono::milliseconds{10};
        Duration fromHost = std::chrono::milliseconds{10};
    };
    /// One datagram that sets out, 0 being the host.
    struct Departure {
        std::uint16_t from;
        std::uint16_t to;
        Duration at;
        std::size_t bytes;
    };

    StrategyStar(const char* name, std::uint16_t participants, const Legs& legs)
        : m_strategy{findSyncStrategy(name)},
          m_legs(participants + 1U, legs),
          m_offsets(participants + 1U)
    {
        m_host = m_strategy->makeHost(starParticipants(participants), LocalTime{});
        for (std::uint16_t id = 1; id <= participants; ++id)
            m_participants.push_back(m_strategy->makeParticipant(
                starSeat(ParticipantId{id}, participants), {}, LocalTime{}));
    }

    void setLegs(std::uint16_t id, const Legs& legs) { m_legs[id] = legs; }
    /// Local time less the host's. @pre before anything runs
    void setOffset(std::uint16_t id, Duration offset)
    {
        m_offsets[id] = offset;
        m_participants[id - 1U] = m_strategy->makeParticipant(
            starSeat(ParticipantId{id}, static_cast<std::uint16_t>(m_participants.size())), {},
            LocalTime{offset});
    }
    /// Datagrams for which this holds are lost.
    void loseIf(std::function<bool(const Departure&)> isLost) { m_isLost = std::move(isLost); }

    void runTo(Duration t)
    {
        for (;;) {
            const Duration next = std::min(nextWake(), nextArrival());
            if (next > t)
                break;
            m_now = std::max(m_now, next);
            deliver();
            serveAll();
        }
        m_now = t;
    }
    void act(std::uint16_t id, const EventCpo& action)
    {
        m_participants[id - 1U]->act(action, local(id));
        serveAll();
    }

    [[nodiscard]] std::optional<ShownObject> shown(std::uint16_t id, ObjectId object) const
    {
        return m_participants[id - 1U]->shown(object, local(id));
    }
    [[nodiscard]] StarParticipant& participant(std::uint16_t id)
    {
        return *m_participants[id - 1U];
    }
    [[nodiscard]] LocalTime local(std::uint16_t id) const
    {
        return LocalTime{m_now + m_offsets[id]};
    }
    [[nodiscard]] const std::vector<Departure>& departures() const { return m_departures; }
    void forgetDepartures() { m_departures.clear(); }
    /// How many datagrams went this way since.
    [[nodiscard]] std::size_t sent(std::uint16_t from, std::uint16_t to) const
    {
        return static_cast<std::size_t>(
            std::ranges::count_if(m_departures, [&](const Departure& departure) {
                return departure.from == from && departure.to == to;
            }));
    }

private:
    struct UnderWay {
        std::uint16_t from;
        std::uint16_t to;
        std::vector<std::byte> bytes;
    };

    StarNode& node(std::uint16_t id) { return id == 0 ? *m_host : *m_participants[id - 1U]; }
    Duration nextArrival() const
    {
        return m_underWay.empty() ? Duration::max() : m_underWay.begin()->first;
    }
    Duration nextWake()
    {
        Duration next = Duration::max();
        for (std::uint16_t id = 0; id < m_legs.size(); ++id)
            if (const LocalTime wake = node(id).nextWake(); wake != LocalTime::max())
                next = std::min(next, wake.time_since_epoch() - m_offsets[id]);
        return next;
    }
    void deliver()
    {
        while (nextArrival() <= m_now) {
            const UnderWay datagram = m_underWay.extract(m_underWay.begin()).mapped();
            node(datagram.to)
                .receive(ParticipantId{datagram.from}, datagram.bytes, local(datagram.to));
        }
    }
    void serveAll()
    {
        for (std::uint16_t id = 0; id < m_legs.size(); ++id) {
            node(id).advance(local(id));
            for (StarDatagram& datagram : node(id).take())
                carry(id, std::move(datagram));
        }
    }
    void carry(std::uint16_t from, StarDatagram datagram)
    {
        const std::uint16_t to = datagram.to.value;
        const Departure departure{from, to, m_now, datagram.bytes.size()};
        m_departures.push_back(departure);
        const Duration delay = from == 0 ? m_legs[to].fromHost : m_legs[from].toHost;
        if (!m_isLost || !m_isLost(departure))
            m_underWay.emplace(m_now + delay, UnderWay{from, to, std::move(datagram.bytes)});
    }

    const SyncStrategy* m_strategy;
    std::vector<Legs> m_legs;
    std::vector<Duration> m_offsets;
    std::unique_ptr<StarNode> m_host;
    std::vector<std::unique_ptr<StarParticipant>> m_participants;
    std::function<bool(const Departure&)> m_isLost;
    std::multimap<Duration, UnderWay> m_underWay;
    std::vector<Departure> m_departures;
    Duration m_now{};
};

/// A quarter turn a second about z, from no turn at all.
inline EventCpo quarterTurns(std::uint32_t action = 1)
{
    EventCpo event;
    event.object = ObjectId{1};
    event.action = action;
    event.axis_A = Vec3f::UnitZ();
    event.rate = static_cast<float>(std::numbers::pi / 2.0);
    return event;
}

/// How far an object has been turned about z, degrees in -180 to 180.
inline double turnedAboutZ_deg(const std::optional<ShownObject>& shown)
{
    if (!shown)
        return std::nan("");
    const Quat& q = shown->acted.X_AO.rotation();
    return inDegrees(radians(2.0 * std::atan2(q.z(), q.w())));
}

} // namespace carina::test
