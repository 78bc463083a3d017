#include "evaluation/network/virtual_star.h"

#include "engine/core/expects.h"

#include <cmath>
#include <random>

namespace carina
{
namespace
{

// Clocks count from when their machine was started; the host's shows this at virtual time 0.
constexpr Duration kUptime = std::chrono::hours{500};
/// Of the disciplined clocks.
constexpr Duration kReadingInterval = std::chrono::seconds{1};

} // namespace

LocalTime VirtualStar::Clock::at(Duration t) const
{
    return LocalTime{kUptime + offset + t
                     + Duration{std::llround(skew * static_cast<double>(t.count()))}};
}

Duration VirtualStar::Clock::timeOf(LocalTime local) const
{
    const Duration shown = local.time_since_epoch() - kUptime - offset;
    Duration t{std::llround(static_cast<double>(shown.count()) / (1.0 + skew)) - 2};
    while (at(t) < local)
        ++t;
    return t;
}

VirtualStar::VirtualStar(const SyncStrategy& strategy, std::uint16_t participants,
                         const DriftScenario& scenario, Legs legs, std::uint64_t seed,
                         Duration start, const StrategyChoice& choice)
    : m_nodes(participants + 1U), m_externalClocks{scenario.externalClocks}, m_nextReading{start}
{
    std::mt19937_64 random{seed};
    const auto evenly = [&] { return static_cast<double>(random() >> 11) * 0x1p-52 - 1.0; };
    const auto legOf = [&](const PathProfile& path) {
        return legs == Legs::HalfPath ? halfOf(path) : path;
    };
    m_nodes[0].node = strategy.makeHost(starParticipants(participants), m_nodes[0].clock.at(start));
    for (std::uint16_t id = 1; id <= participants; ++id) {
        Node& node = m_nodes[id];
        const double side = id % 2 == 1 ? -1.0 : 1.0;
        const double offset = scenario.areClocksAtLimits ? side : evenly();
        const double skew = scenario.areClocksAtLimits ? side : evenly();
        node.clock = {fromSeconds(offset * toSeconds(scenario.clockOffset)),
                      skew * scenario.clockSkew};
        const bool isActor = id == 1;
        node.toHost.emplace(legOf(isActor ? scenario.forward : scenario.backward), random());
        node.fromHost.emplace(legOf(isActor ? scenario.backward : scenario.forward), random());
        node.node = strategy.makeParticipant(starSeat(ParticipantId{id}, participants), choice,
                                             node.clock.at(start));
    }
    for (Node& node : m_nodes)
        if (m_externalClocks)
            node.externalError = fromSeconds(evenly() * toSeconds(*m_externalClocks));
    for (std::uint16_t id = 0; id <= participants; ++id)
        serve(id, start);
}

void VirtualStar::runTo(Duration t)
{
    for (; m_externalClocks && m_nextReading <= t; m_nextReading += kReadingInterval) {
        processTo(m_nextReading);
        readExternal(m_nextReading);
    }
    processTo(t);
}

void VirtualStar::readExternal(Duration now)
{
    // The standard deviation of an even distribution, and the true time with the clock's error.
    const Duration error = fromSeconds(toSeconds(*m_externalClocks) / std::sqrt(3.0));
    for (std::uint16_t id = 0; id < m_nodes.size(); ++id) {
        const Node& node = m_nodes[id];
        const LocalTime local = node.clock.at(now);
        const Duration external = kUptime + now + node.externalError;
        node.node->readExternal({external - local.time_since_epoch(), error}, local);
        serve(id, now);
    }
}

void VirtualStar::processTo(Duration t)
{
    while (!m_queue.empty() && m_queue.top().at <= t) {
        const Happening happening = m_queue.top();
        m_queue.pop();
        Node& node = m_nodes[happening.node];
        if (!happening.bytes.empty())
            node.node->receive(ParticipantId{happening.from}, happening.bytes,
                               node.clock.at(happening.at));
        else if (happening.at != node.wake)
            continue;
        serve(happening.node, happening.at);
    }
}

void VirtualStar::act(const EventCpo& action, Duration t)
{
    runTo(t);
    auto& actor = static_cast<StarParticipant&>(*m_nodes[1].node);
    actor.act(action, m_nodes[1].clock.at(t));
    serve(1, t);
}

void VirtualStar::serve(std::uint16_t id, Duration now)
{
    Node& node = m_nodes[id];
    node.node->advance(node.clock.at(now));
    for (StarDatagram& datagram : node.node->take())
        carry(id, std::move(datagram), now);
    const LocalTime wake = node.node->nextWake();
    if (wake == LocalTime::max()) {
        node.wake = Duration::max();
        return;
    }
    const Duration at = std::max(node.clock.timeOf(wake), now + Duration{1});
    if (at == node.wake)
        return;
    node.wake = at;
    m_queue.push({at, m_order++, id, id, {}});
}

void VirtualStar::carry(std::uint16_t from, StarDatagram datagram, Duration now)
{
    const std::uint16_t to = datagram.to.value;
    CARINA_EXPECTS(to < m_nodes.size() && (from == 0) != (to == 0));
    m_bytes += datagram.bytes.size();
    VirtualLink& link = from == 0 ? *m_nodes[to].fromHost : *m_nodes[from].toHost;
    const auto arrivals = link.send(datagram.bytes.size(), now);
    for (std::size_t copy = 0; copy < arrivals.count; ++copy)
        m_queue.push({arrivals.at[copy], m_order++, to, from, datagram.bytes});
}

const StarParticipant& VirtualStar::participant(std::uint16_t id) const
{
    CARINA_EXPECTS(id >= 1);
    return static_cast<const StarParticipant&>(*m_nodes[id].node);
}

std::optional<ShownObject> VirtualStar::shown(std::uint16_t id, ObjectId object, Duration t) const
{
    return participant(id).shown(object, m_nodes[id].clock.at(t));
}

std::optional<Duration> VirtualStar::clockError(std::uint16_t id, Duration t) const
{
    const auto session = participant(id).sessionTime(m_nodes[id].clock.at(t));
    if (!session)
        return std::nullopt;
    return session->time_since_epoch() - m_nodes[0].clock.at(t).time_since_epoch();
}

VirtualStar::Traffic VirtualStar::traffic() const
{
    Traffic traffic{.bytes = m_bytes};
    for (const Node& node : m_nodes)
        traffic.probes += node.node->probesSent();
    return traffic;
}

Duration VirtualStar::throughLeg(VirtualLink& link, Duration now)
{
    for (Duration waited{}; waited < kOracleGivesUp; waited += kOracleRepeat)
        if (const auto delay = link.delayAt(now + waited))
            return waited + *delay;
    return kOracleGivesUp;
}

Duration VirtualStar::leastDelay(std::uint16_t id, Duration t)
{
    const Duration atHost = throughLeg(*m_nodes[1].toHost, t);
    return atHost + throughLeg(*m_nodes[id].fromHost, t + atHost);
}

} // namespace carina
