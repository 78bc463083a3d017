#pragma once

#include "engine/core/session_time.h"
#include "evaluation/network/drift_scenario.h"

#include <QString>
#include <QStringList>

#include <memory>
#include <optional>
#include <string>

namespace carina
{

/// The emulated network between the programs of a real-time session: a host, and participants 1 to
/// n, each with its leg of a scenario's path to the host. Runs on this thread's event loop.
class LiveNetwork
{
public:
    /// The address and port at which a participant reaches the host.
    struct Place {
        std::string address;
        std::uint16_t port = 0;
    };
    /// The path profiles between a participant and the host: half of the scenario's path each, as
    /// in virtual time. The actor is participant 1.
    struct Legs {
        PathProfile toHost;
        PathProfile fromHost;
    };
    [[nodiscard]] static Legs legsOf(std::size_t participant, const DriftScenario& scenario);

    virtual ~LiveNetwork() = default;

    /// The kind of network, as one word.
    [[nodiscard]] virtual QString name() const = 0;
    /// Whether the host must accept connections from other computers.
    [[nodiscard]] virtual bool isHostOpen() const = 0;
    /// The command line that starts a program at the node of the host (0) or of a participant.
    [[nodiscard]] virtual QStringList inPlace(std::size_t who,
                                              const QStringList& program) const = 0;
    /// Where a participant reaches a host that listens on `hostPort`; to be called once per
    /// participant.
    [[nodiscard]] virtual Place placeOfHost(std::size_t participant, std::uint16_t hostPort) = 0;
    /// Sets the scenario's time 0 on the machine's clock.
    virtual void beginAt(LocalTime machine) = 0;
    /// Bytes of all datagrams carried so far; std::nullopt if they are not counted.
    [[nodiscard]] virtual std::optional<std::uint64_t> bytes() const = 0;
    /// The least delay from participant 1 to another for a message sent at time t after time 0.
    [[nodiscard]] virtual Duration leastDelay(std::size_t participant, Duration t) = 0;
};

/// A network of one LossyRelay per participant, in this program.
[[nodiscard]] std::unique_ptr<LiveNetwork>
relayedNetwork(std::size_t participants, const DriftScenario& scenario, std::uint32_t seed);

} // namespace carina
