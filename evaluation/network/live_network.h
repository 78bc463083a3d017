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

/// The network between the programs of a live session: a host, and participants 1 to n, each with
/// its leg of a scenario's paths to the host. Runs on this thread's event loop.
class LiveNetwork
{
public:
    /// Where a participant reaches the host.
    struct Place {
        std::string address;
        std::uint16_t port = 0;
    };
    /// What a participant's datagrams meet on their way to the host and back: half of a path each,
    /// as in virtual time. The actor is participant 1.
    struct Legs {
        PathProfile toHost;
        PathProfile fromHost;
    };
    [[nodiscard]] static Legs legsOf(std::size_t participant, const DriftScenario& scenario);

    virtual ~LiveNetwork() = default;

    /// Which network it is: a word.
    [[nodiscard]] virtual QString name() const = 0;
    /// The host has to be open to other computers.
    [[nodiscard]] virtual bool isHostOpen() const = 0;
    /// The words that start a program where the host, 0, or a participant is.
    [[nodiscard]] virtual QStringList inPlace(std::size_t who,
                                              const QStringList& program) const = 0;
    /// How a participant reaches a host that listens on `hostPort`; asked once of each.
    [[nodiscard]] virtual Place placeOfHost(std::size_t participant, std::uint16_t hostPort) = 0;
    /// The scenario's time 0 is then, on the machine's clock.
    virtual void beginAt(LocalTime machine) = 0;
    /// Bytes of all datagrams so far, as they are on the way; nothing where that is not counted.
    [[nodiscard]] virtual std::optional<std::uint64_t> bytes() const = 0;
    /// No news gets from participant 1 to another sooner, if it begins so long after time 0.
    [[nodiscard]] virtual Duration leastDelay(std::size_t participant, Duration t) = 0;
};

/// A relay for each participant, in this program.
[[nodiscard]] std::unique_ptr<LiveNetwork>
relayedNetwork(std::size_t participants, const DriftScenario& scenario, std::uint32_t seed);

} // namespace carina
