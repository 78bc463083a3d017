#pragma once

#include "engine/core/session_time.h"
#include "engine/session/facts/fact_store.h"

#include <optional>
#include <string>

namespace carina
{

/// Names this run of the machine, within which CLOCK_MONOTONIC goes on; empty where the system does
/// not tell.
[[nodiscard]] std::string readBootId();

/// What a session host adds to its local time, so that session time begins at an arbitrary moment,
/// goes on across a crash of the host as if nothing had been, and after a reboot goes on from the
/// last thing that happened.
///
/// @param anchor kept by the last run of this session's host
/// @param lastCommitted of the log; nothing for a new session
/// @param random for the epoch of a new session
[[nodiscard]] Duration sessionClockOffset(const std::optional<ClockAnchor>& anchor,
                                          const std::string& bootId,
                                          std::optional<SessionTime> lastCommitted, LocalTime now,
                                          std::uint64_t random);

} // namespace carina
