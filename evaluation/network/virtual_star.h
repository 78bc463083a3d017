#pragma once

#include "engine/sync/strategies/strategy.h"
#include "evaluation/network/drift_scenario.h"

#include <cstdint>
#include <queue>

namespace carina
{

/// A session in virtual time: a host, participants 1 to n with clocks of their own, and a link each
/// way between them and the host, all driven by one queue of events. Participant 1 is the actor,
/// all others are viewers; the host is none of them.
class VirtualStar
{
public:
    enum class Legs : std::uint8_t {
        HalfPath, ///< each leg is half the scenario's path, so that the way over the host is one
        FullPath, ///< each leg is a whole path, as an access link: the way over the host is two
    };

    struct Traffic {
        std::uint64_t bytes = 0; ///< payload of all datagrams of all nodes
        std::uint64_t probes = 0;
    };

    /// Begins at virtual time `start`.
    VirtualStar(const SyncStrategy& strategy, std::uint16_t participants,
                const DriftScenario& scenario, Legs legs, std::uint64_t seed, Duration start);

    /// Lets everything happen that happens up to and at t. @pre t is not before the last.
    void runTo(Duration t);
    /// The actor acts, at t.
    void act(const EventCpo& action, Duration t);

    [[nodiscard]] std::uint16_t participants() const { return std::uint16_t(m_nodes.size() - 1); }
    /// What participant `id` draws at t.
    [[nodiscard]] std::optional<ShownObject> shown(std::uint16_t id, ObjectId object,
                                                   Duration t) const;
    /// The participant's session clock less the host's; nothing where it has none.
    [[nodiscard]] std::optional<Duration> clockError(std::uint16_t id, Duration t) const;
    [[nodiscard]] Traffic traffic() const;

    /// How long an action of time t takes to viewer `id` at least: the delays that the links have
    /// just then, each leg tried again every kOracleRepeat until something gets through.
    [[nodiscard]] Duration leastDelay(std::uint16_t id, Duration t);
    /// The same of one leg.
    [[nodiscard]] static Duration throughLeg(VirtualLink& link, Duration now);
    static constexpr Duration kOracleRepeat = std::chrono::milliseconds{10};
    static constexpr Duration kOracleGivesUp = std::chrono::seconds{10};

private:
    struct Clock {
        Duration offset{};
        double skew = 0.0;

        [[nodiscard]] LocalTime at(Duration t) const;
        /// The first time at which the clock shows `local` or more.
        [[nodiscard]] Duration timeOf(LocalTime local) const;
    };
    struct Node {
        Clock clock;
        std::unique_ptr<StarNode> node;
        std::optional<VirtualLink> toHost;
        std::optional<VirtualLink> fromHost;
        Duration wake = Duration::max();
    };
    struct Happening {
        Duration at;
        std::uint64_t order;
        std::uint16_t node;
        std::uint16_t from;
        std::vector<std::byte> bytes; ///< empty for a wake-up

        friend bool operator>(const Happening& a, const Happening& b)
        {
            return a.at != b.at ? a.at > b.at : a.order > b.order;
        }
    };

    void serve(std::uint16_t id, Duration now);
    void carry(std::uint16_t from, StarDatagram datagram, Duration now);
    [[nodiscard]] const StarParticipant& participant(std::uint16_t id) const;

    std::vector<Node> m_nodes; // the host first
    std::priority_queue<Happening, std::vector<Happening>, std::greater<>> m_queue;
    std::uint64_t m_order = 0;
    std::uint64_t m_bytes = 0;
};

} // namespace carina
