#pragma once

#include "engine/core/result.h"
#include "engine/net/entry/access_key.h"
#include "engine/sync/strategies/strategy.h"
#include "evaluation/drift/action_script.h"
#include "evaluation/network/drift_scenario.h"

#include <QByteArray>

#include <string>

namespace carina::lab
{

/// What one program of a live drift experiment is to do.
struct LiveOrders {
    enum class Part : std::uint8_t { Host, Actor, Viewer };

    Part part = Part::Viewer;
    std::string name{};                ///< under which it is in the session
    std::string address = "127.0.0.1"; ///< of the host, as this program reaches it
    std::uint16_t port = 0;            ///< the same; 0 for the host
    bool isOpen = false;               ///< the host's: to other computers
    AccessKey key{};                   ///< in place of one derived from a join code
    StrategyKind strategy = StrategyKind::SessionClock; ///< the host's choice
    Duration longestLag = StrategyChoice{}.longestLag;  ///< the same, of local lag
    std::uint16_t asaDelays = AsaParameters{}.delays;   ///< the same, of the ASA
    DisplayFrames frames{}; ///< of this program's view; counted from the first action
    ActionScript::Settings script{};
    std::uint32_t seed = 1; ///< of the script
};

/// One line, as it is written to the program's standard input.
[[nodiscard]] QByteArray lineOf(const LiveOrders& orders);
/// @returns FileMalformed for any other line.
[[nodiscard]] Result<LiveOrders> ordersIn(const QByteArray& line);

} // namespace carina::lab
