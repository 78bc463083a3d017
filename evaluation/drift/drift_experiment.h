#pragma once

#include "evaluation/drift/action_script.h"
#include "evaluation/network/drift_scenario.h"
#include "evaluation/network/virtual_star.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace carina
{

/// One run of the drift experiment.
struct DriftSettings {
    const SyncStrategy* strategy = nullptr;
    std::uint16_t participants = 2; ///< one of them acts; the host is none of them
    ActionScript::Settings script;
    DriftScenario scenario;
    VirtualStar::Legs legs = VirtualStar::Legs::HalfPath;
    std::uint32_t seed = 1;
};

/// How far the views were from the truth just before the next action, mean over the viewers.
struct ActionDrift {
    double angle = 0.0;    ///< radians, at most pi
    double rawAngle = 0.0; ///< 2 acos(w), the 2004 paper's: radians, above pi where w < 0
    double distance = 0.0; ///< metres
};

/// How far the viewers' views were from the truth of the same instant, over all viewers. Angles are
/// 2 atan2(|v|, |w|) of q_s q_c^-1, radians; metres; seconds.
struct DriftFigures {
    double atEvent = 0.0;             ///< mean, just before the next action
    double timeAverage = 0.0;         ///< mean over time
    double p95 = 0.0;                 ///< over time
    double position = 0.0;            ///< mean over time
    double limit = 0.0;               ///< no strategy's time average is below it
    double positionLimit = 0.0;       ///< the same of the position
    std::optional<double> clockError; ///< mean |session clock - host's|, where there is one
    double bytesPerSecond = 0.0;      ///< payload sent and received by a participant
    double probesPerSecond = 0.0;     ///< of all nodes together
    std::vector<ActionDrift> actions; ///< in their order
};

/// Runs it in virtual time. The truth is the script's, in closed form, and the time is the
/// network's: neither comes from the strategy.
///
/// The physical limit: that action k has begun cannot be known before the delay d of that moment
/// has passed (VirtualStar::leastDelay), and until then the error grows as |w_k - w_(k-1)| u. So
///
///     time average >= mean over actions and viewers of |w_k - w_(k-1)| d^2 / (2 T)
///
/// with T the time of an action and d at most T. That of the position has velocities in place of
/// angular ones.
[[nodiscard]] DriftFigures runDrift(const DriftSettings& settings);

/// The mean of runs with the seeds `seed` to seed + seeds - 1. @pre seeds >= 1
[[nodiscard]] DriftFigures runDrift(DriftSettings settings, int seeds);

} // namespace carina
