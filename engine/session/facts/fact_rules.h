#pragma once

#include "engine/core/result.h"
#include "engine/session/facts/facts.h"

#include <cstddef>

namespace carina
{

/// The range that a patient's breathing may be set to; controls show it, the host enforces it.
inline constexpr Frequency kSlowestBreathing = perMinute(4.0);
inline constexpr Frequency kFastestBreathing = perMinute(60.0);
inline constexpr Volume kSmallestTidalVolume = millilitres(20.0);
inline constexpr Volume kLargestTidalVolume = millilitres(2000.0);
inline constexpr double kShortestInspiration = 0.1; ///< as a fraction of the breath
inline constexpr double kLongestInspiration = 0.9;

/// Bytes of UTF-8 in a name or hash; a SHA-256 in hex just fits.
inline constexpr std::size_t kLongestText = 64;

/// Whether the values of a fact can be true of any session: numbers in their range, texts short
/// enough and UTF-8. Names that a person types are checked with it before they are proposed.
/// @returns OutOfRange naming the value and its range; NotFinite for a NaN or an infinity.
[[nodiscard]] Result<void> checkBody(const FactBody& body);

} // namespace carina
