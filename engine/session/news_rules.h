#pragma once

#include "engine/core/result.h"
#include "engine/session/session_state.h"

namespace carina
{

/// Shortest time between two breaths of the manikin of a station: at the fastest breathing that can
/// be set, with a tenth for what the detection of their beginnings varies by.
inline constexpr Duration kShortestBreath = std::chrono::milliseconds{900};

/// Shortest time between two entries of one step of an intubation at a station, of ours: no hand
/// does the same twice within it, and a monitor has hysteresis.
inline constexpr Duration kShortestStep = std::chrono::seconds{1};

/// Whether a fact of those that programs report by themselves, or that people repeat, says anything
/// new: how a registration stands, the place of a participant, cuff and stylet, where they change;
/// a breath of the manikin, where it follows the last one by kShortestBreath and has an effect
/// (RespirationTimeline::addBreath); a step of an intubation, where it was noted within
/// kLongestNews, and follows the last one of its kind by kShortestStep. Otherwise the log would
/// grow by what changes nothing.
/// @pre the station is known
/// @returns OutOfRange. Nothing for other facts.
[[nodiscard]] Result<void> checkNews(const SessionState& state, const Fact& fact);

} // namespace carina
