#pragma once

#include "engine/core/result.h"
#include "evaluation/network/live_network.h"

#include <filesystem>

namespace carina
{

/// A scenario's legs in the words of netlab, an emulator that gives every program a network
/// namespace of its own: the participants p1, p2 ... around `host`.
///
/// @param hasStepped whether the step in the delay has come
/// @param trace where to write a scenario's trace, if it has one
[[nodiscard]] QStringList netlabLinks(const DriftScenario& scenario, std::size_t participants,
                                      bool hasStepped, const std::filesystem::path& trace);

/// A network that the program netlab emulates, which takes root's rights. Bursts are drawn for each
/// datagram there, not for every 10 ms.
///
/// @returns NotPermitted where it cannot be started; FileUnwritable.
[[nodiscard]] Result<std::unique_ptr<LiveNetwork>> netlabNetwork(const QString& program,
                                                                 std::size_t participants,
                                                                 const DriftScenario& scenario,
                                                                 std::uint32_t seed);

} // namespace carina
