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
    std::uint16_t participants = 2; ///< one of them acts; the host is not counted
    ActionScript::Settings script;
    DriftScenario scenario;
    VirtualStar::Legs legs = VirtualStar::Legs::HalfPath;
    std::uint32_t seed = 1;
    /// Before the first action. Unless set long enough for a history of 100 delays at one a second.
    Duration warmUp = std::chrono::seconds{130};
    Duration longestLag = StrategyChoice{}.longestLag; ///< with local lag
    AsaParameters asa{};                               ///< with the ASA
};

/// The drift just before the next action, mean over the viewers.
struct ActionDrift {
    double angle = 0.0; ///< radians, at most pi
    /// 2 acos(w), as in Hamza-Lup et al. 2004: radians, above pi if w < 0. It depends on which of q
    /// and -q each of the two programs has: here the actor the product of its rotations, a viewer
    /// the one with w >= 0.
    double rawAngle = 0.0;
    double distance = 0.0; ///< metres
};

/// The drift of the viewers from the actor's view at the same instant, over all viewers. Angles are
/// 2 atan2(|v|, |w|) of q_s q_c^-1, radians; distances in metres; times in seconds.
struct DriftFigures {
    double atEvent = 0.0;             ///< mean, just before the next action
    double timeAverage = 0.0;         ///< mean over time
    double p95 = 0.0;                 ///< over time
    double position = 0.0;            ///< mean over time
    double limit = 0.0;               ///< lower bound of timeAverage unless the actor waits
    double positionLimit = 0.0;       ///< lower bound of position
    double response = 0.0;            ///< mean, from an action to its beginning in its actor's view
    std::optional<double> clockError; ///< mean |session clock - host's|, if there is one
    double bytesPerSecond = 0.0;      ///< payload sent and received by a participant
    double probesPerSecond = 0.0;     ///< of all nodes together
    std::vector<ActionDrift> actions; ///< in their order
    /// Mean over time without the actions that a viewer did not show, and those after them, whose
    /// news found it far off (ShownActions); nothing where none is left.
    std::optional<double> timeAverageShown;
    double lost = 0.0; ///< how many were not shown, all viewers together
};

/// Runs the experiment in virtual time, which is that of the virtual network. The drift is the
/// difference of two views at the same time: of a viewer's and the actor's.
///
/// The physical limit: a viewer cannot be informed of action k before the delay d at that time has
/// passed (VirtualStar::leastDelay); until then the error grows with the time u since its start as
/// |w_k - w_(k-1)| u. Hence
///
///     time average >= mean over actions and viewers of |w_k - w_(k-1)| d^2 / (2 T)
///
/// with T the duration of an action and d limited to T. For the position the angular velocities are
/// replaced by velocities.
[[nodiscard]] DriftFigures runDrift(const DriftSettings& settings);

/// The mean of the runs with the seeds settings.seed to settings.seed + seeds - 1. @pre seeds >= 1
[[nodiscard]] DriftFigures runDrift(DriftSettings settings, int seeds);

} // namespace carina
