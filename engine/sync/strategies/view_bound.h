#pragma once

#include "engine/core/session_time.h"
#include "engine/sync/strategies/drift.h"

namespace carina
{

/// What a hand does at most, each second: the accelerations of quick work, 510 deg/s^2 and 1 m/s^2
/// root mean square, as amplitudes of an oscillation.
inline constexpr Drift kHandAcceleration{degrees(720.0), metres(1.4)};

/// What a viewer has is older than the delay by a frame of the tracker, a tick of its owner and a
/// frame of the viewer, 60 a second each.
inline constexpr Duration kSampleAge = std::chrono::milliseconds{50};

/// Up to which drift two programs show a tracked object in the same place.
///
/// Two samples of a tool at rest differ by two errors of the tracker: n. A viewer goes on with the
/// motion that it knows. For what a hand has done since, that is off by the limit where it began or
/// stopped at once, or by a t^2 / 2 where it went on accelerating:
///
///     n + max(limit, a t^2 / 2)        t = delay + kSampleAge
///
/// @param limit speed x delay
[[nodiscard]] Drift trackedViewBound(const Drift& limit, Duration delay);

} // namespace carina
