#pragma once

#include "engine/core/result.h"
#include "engine/session/facts/facts.h"

#include <cstddef>

namespace carina
{

/// The ranges to which a patient's breathing may be set; controls offer them, the host enforces
/// them.
inline constexpr Frequency kSlowestBreathing = perMinute(4.0);
inline constexpr Frequency kFastestBreathing = perMinute(60.0);
inline constexpr Volume kSmallestTidalVolume = millilitres(10.0);
inline constexpr Volume kLargestTidalVolume = millilitres(2000.0);
inline constexpr double kShortestInspiration = 0.1; ///< as a fraction of the breath
inline constexpr double kLongestInspiration = 0.9;

/// Bytes of UTF-8 in a name or hash; a SHA-256 in hexadecimal has exactly this length.
inline constexpr std::size_t kLongestText = 64;

/// Whether the values of a fact are possible in any session: numbers within their range, texts of
/// valid length and UTF-8. Use it for names that a person types before they are proposed.
/// @returns OutOfRange naming the value and its range; NotFinite for NaN or infinity.
[[nodiscard]] Result<void> checkBody(const FactBody& body);

} // namespace carina
