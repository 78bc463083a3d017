#pragma once

#include "engine/core/session_time.h"
#include "engine/session/facts/fact_store.h"

#include <optional>
#include <string>

namespace carina
{

/// Identifies the boot of the machine, within which CLOCK_MONOTONIC is comparable; empty where the
/// system does not provide it.
[[nodiscard]] std::string readBootId();

/// Whether an anchor of this boot contradicts the log: by it the session would now be before its
/// last fact, or have gone on since for a day longer than the machine is running.
[[nodiscard]] bool contradictsLog(const ClockAnchor& anchor, const std::string& bootId,
                                  SessionTime lastCommitted, LocalTime now);

/// Session time less local time at a host. A new session begins at a random session time. After a
/// restart of the host within one boot, session time continues as if there had been none; after a
/// reboot, or with an anchor that contradicts the log, it continues from the last committed fact.
///
/// @param anchor stored by the last run of this session's host
/// @param lastCommitted time of the last fact of the log; nothing for a new session
/// @param random chooses the start time of a new session
[[nodiscard]] Duration sessionClockOffset(const std::optional<ClockAnchor>& anchor,
                                          const std::string& bootId,
                                          std::optional<SessionTime> lastCommitted, LocalTime now,
                                          std::uint64_t random);

} // namespace carina
