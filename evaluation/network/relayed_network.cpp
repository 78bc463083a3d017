#include "evaluation/network/live_network.h"
#include "evaluation/network/lossy_relay.h"
#include "evaluation/network/virtual_star.h"

#include <vector>

namespace carina
{
namespace
{

class RelayedNetwork : public LiveNetwork
{
public:
    RelayedNetwork(std::size_t participants, DriftScenario scenario, std::uint32_t seed)
        : m_scenario{std::move(scenario)}, m_seed{seed}, m_relays(participants)
    {
    }

    QString name() const override { return QStringLiteral("relay"); }
    bool isHostOpen() const override { return false; }
    QStringList inPlace(std::size_t, const QStringList& program) const override { return program; }

    Place placeOfHost(std::size_t participant, std::uint16_t hostPort) override
    {
        const Legs legs = legsOf(participant, m_scenario);
        auto& relay = m_relays.at(participant - 1);
        relay = std::make_unique<LossyRelay>(
            hostPort, LossyRelay::Paths{legs.toHost, legs.fromHost}, seedOf(participant));
        return {"127.0.0.1", relay->port()};
    }

    void beginAt(LocalTime machine) override
    {
        for (const auto& relay : m_relays)
            relay->beginAt(machine);
    }

    std::optional<std::uint64_t> bytes() const override
    {
        std::uint64_t bytes = 0;
        for (const auto& relay : m_relays)
            bytes += relay->bytes();
        return bytes;
    }

    Duration leastDelay(std::size_t participant, Duration t) override
    {
        // The relays' own links, asked again.
        VirtualLink toHost{legsOf(1, m_scenario).toHost, LossyRelay::seedToHost(seedOf(1))};
        VirtualLink fromHost{legsOf(participant, m_scenario).fromHost,
                             LossyRelay::seedToClients(seedOf(participant))};
        const Duration atHost = VirtualStar::throughLeg(toHost, t);
        return atHost + VirtualStar::throughLeg(fromHost, t + atHost);
    }

private:
    std::uint64_t seedOf(std::size_t participant) const
    {
        return (std::uint64_t{m_seed} << 8U) + participant;
    }

    DriftScenario m_scenario;
    std::uint32_t m_seed;
    std::vector<std::unique_ptr<LossyRelay>> m_relays;
};

} // namespace

LiveNetwork::Legs LiveNetwork::legsOf(std::size_t participant, const DriftScenario& scenario)
{
    if (participant == 1)
        return {halfOf(scenario.forward), halfOf(scenario.backward)};
    return {halfOf(scenario.backward), halfOf(scenario.forward)};
}

std::unique_ptr<LiveNetwork> relayedNetwork(std::size_t participants, const DriftScenario& scenario,
                                            std::uint32_t seed)
{
    return std::make_unique<RelayedNetwork>(participants, scenario, seed);
}

} // namespace carina
