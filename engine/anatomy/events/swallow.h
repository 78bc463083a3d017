#pragma once

#include "engine/core/session_time.h"

namespace carina
{

/// A patient who swallows does so at every whole multiple of this on the session clock, so that it
/// is the same at every site, whoever joins late too. Of ours: awake and at rest people swallow 28
/// times an hour, and 1.7 times in anaesthesia (D'Angelo et al., Anesthesiology 2014;121:1175),
/// which nobody would wait for.
inline constexpr Duration kSwallowEvery = std::chrono::seconds{8};

/// From the first motion of the cords until they are open again: 2.2 s (8 people, by video
/// laryngoscopy; Shaker et al., Gastroenterology 1990;98:1478).
inline constexpr Duration kSwallow = std::chrono::milliseconds{2200};

/// How far a swallow has come at a time, 0 to 1: it rises for 0.9 s, stays for 0.4 s and falls
/// until kSwallow is over (of ours, but for kSwallow), and is 0 between swallows.
[[nodiscard]] double swallowAt(SessionTime t);

/// Up to so much of a swallow the cords close, and nothing else moves: the larynx rises 0.3 s after
/// they begin (0.33 s, Shaker et al.), and sinks before they open.
inline constexpr double kCordsShutInSwallow = 0.25;

/// How far the cords are shut in so much of a swallow, 0 to 1.
[[nodiscard]] double cordsInSwallow(double amount);
/// How far all else has moved, 0 to 1.
[[nodiscard]] double riseInSwallow(double amount);

} // namespace carina
