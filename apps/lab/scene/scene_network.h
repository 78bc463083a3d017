#pragma once

#include "engine/core/result.h"
#include "evaluation/network/drift_scenario.h"

#include <QString>
#include <QStringList>

#include <memory>
#include <set>

namespace carina::lab
{

/// The network between the console that hosts a session and the participants 1 to n: some are at
/// the end of a long path, which has all of the delay of a scenario, the others on the spot.
class SceneNetwork
{
public:
    /// Where a participant finds the host.
    struct Door {
        QString address;
        std::uint16_t port = 0;
    };

    virtual ~SceneNetwork() = default;

    /// The kind of network, as one word.
    [[nodiscard]] virtual QString name() const = 0;
    /// What the console needs besides to be reached.
    [[nodiscard]] virtual QStringList consoleOptions() const = 0;
    /// The command line that runs a program at the place of the console (0) or of a participant.
    [[nodiscard]] virtual QStringList inPlace(int who, const QStringList& program) const = 0;
    /// To be called once for each participant, when the console is there.
    [[nodiscard]] virtual Door doorOf(int participant) = 0;
};

struct SceneNetworkSettings {
    int participants = 0;
    std::set<int> remote{}; ///< those at the end of the long path
    DriftScenario scenario{};
    std::uint32_t seed = 1;
    std::uint16_t hostPort = 0;
};

/// On loopback; in front of each remote participant is a relay in this process, on its event loop.
[[nodiscard]] std::unique_ptr<SceneNetwork>
relayedSceneNetwork(const SceneNetworkSettings& settings);

/// Each program in a network namespace of its own, by the program netlab, as root. Those on the
/// spot have the path of the scenario lan.
/// @returns the errors of NetlabProcess::start
[[nodiscard]] Result<std::unique_ptr<SceneNetwork>>
netlabSceneNetwork(const QString& program, const SceneNetworkSettings& settings);

} // namespace carina::lab
