#pragma once

#include "engine/sync/strategies/strategy.h"
#include "evaluation/network/drift_scenario.h"

#include <cstdint>
#include <queue>

namespace carina
{

/// A session in virtual time: a host, participants 1 to n with individual clocks, and a link in
/// each direction between each of them and the host, driven by one event queue. Participant 1 is
/// the actor, all others are viewers; the host is not a participant.
class VirtualStar
{
public:
    enum class Legs : std::uint8_t {
        HalfPath, ///< each leg is half of the scenario's path, so that the route over the host is
                  ///< one path
        FullPath, ///< each leg is a whole path, such as an access link: the route over the host is
                  ///< two paths
    };

    struct Traffic {
        std::uint64_t bytes = 0; ///< payload of all datagrams of all nodes
        std::uint64_t probes = 0;
    };

    /// Starts at virtual time `start`. @param choice what the strategy leaves to its user
    VirtualStar(const SyncStrategy& strategy, std::uint16_t participants,
                const DriftScenario& scenario, Legs legs, std::uint64_t seed, Duration start,
                const StrategyChoice& choice = {});

    /// Processes all events up to and including t. @pre t is not before that of the last call.
    void runTo(Duration t);
    /// The actor performs an action at t.
    void act(const EventCpo& action, Duration t);

    [[nodiscard]] std::uint16_t participants() const { return std::uint16_t(m_nodes.size() - 1); }
    /// The object as drawn by participant `id` at t.
    [[nodiscard]] std::optional<ShownObject> shown(std::uint16_t id, ObjectId object,
                                                   Duration t) const;
    /// The participant's session clock minus the host's; std::nullopt if it has none.
    [[nodiscard]] std::optional<Duration> clockError(std::uint16_t id, Duration t) const;
    [[nodiscard]] Traffic traffic() const;

    /// The least time in which an action at t can reach viewer `id`: the sum of the present delays
    /// of both legs, where a lost datagram is repeated every kOracleRepeat until one gets through.
    /// A leg that loses all of them for kOracleGivesUp counts as that long.
    [[nodiscard]] Duration leastDelay(std::uint16_t id, Duration t);
    /// The same for one leg.
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
        Duration externalError{}; ///< of its disciplined clock, if the scenario has them
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

    void processTo(Duration t);
    void readExternal(Duration now);
    void serve(std::uint16_t id, Duration now);
    void carry(std::uint16_t from, StarDatagram datagram, Duration now);
    [[nodiscard]] const StarParticipant& participant(std::uint16_t id) const;

    std::vector<Node> m_nodes; // the host first
    std::priority_queue<Happening, std::vector<Happening>, std::greater<>> m_queue;
    std::optional<Duration> m_externalClocks; // as in the scenario
    Duration m_nextReading{};
    std::uint64_t m_order = 0;
    std::uint64_t m_bytes = 0;
};

} // namespace carina
