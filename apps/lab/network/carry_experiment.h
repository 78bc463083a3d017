#pragma once

#include "engine/core/result.h"
#include "engine/core/session_time.h"

#include <cstdint>
#include <vector>

namespace carina::lab
{

struct CarrySettings {
    int megabytes = 40;                       ///< of the set
    Duration phase = std::chrono::seconds{5}; ///< each of the three
};

/// How old poses were when they came, in three phases of one session, and how fast the set was.
struct CarryFigures {
    std::vector<Duration> before; ///< sorted; nothing but the session goes on
    std::vector<Duration> during; ///< the set is fetched again and again
    std::vector<Duration> after;
    std::uint64_t bytes = 0; ///< of the set
    int sets = 0;            ///< that came whole
    Duration fetching{};     ///< that they took together
};

/// A host that shares a tube 60 times a second and a participant, over real sockets on loopback.
/// The participant fetches a made-up anatomy set in the second phase.
/// @returns what the programs fail with; HostSilent when nobody comes in.
[[nodiscard]] Result<CarryFigures> measureCarrying(const CarrySettings& settings);

} // namespace carina::lab
