#pragma once

#include "engine/core/result.h"
#include "evaluation/network/live_network.h"

#include <filesystem>

namespace carina
{

/// A scenario's legs as arguments of netlab, an emulator that runs every program in its own network
/// namespace: the participants p1, p2 ... around `host`.
///
/// @param hasStepped whether the step of the delay (PathProfile::stepAt) has occurred
/// @param trace file to write the scenario's trace to, if it has one
[[nodiscard]] QStringList netlabLinks(const DriftScenario& scenario, std::size_t participants,
                                      bool hasStepped, const std::filesystem::path& trace);

/// A network emulated by the program netlab, which requires root privileges. There the state of a
/// loss burst changes per datagram, not every 10 ms.
///
/// @returns NotPermitted if it cannot be started; FileUnwritable.
[[nodiscard]] Result<std::unique_ptr<LiveNetwork>> netlabNetwork(const QString& program,
                                                                 std::size_t participants,
                                                                 const DriftScenario& scenario,
                                                                 std::uint32_t seed);

} // namespace carina
