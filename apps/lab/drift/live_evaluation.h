#pragma once

#include "apps/lab/drift/live_log.h"
#include "evaluation/drift/action_script.h"
#include "evaluation/drift/drift_experiment.h"

#include <functional>
#include <span>

namespace carina::lab
{

/// What is left of a live session when all its programs have ended.
struct LiveRun {
    ActionScript::Settings settings;
    std::uint32_t seed = 1;            ///< of the script
    LiveLog host;                      ///< in the middle, and nobody's view
    std::vector<LiveLog> participants; ///< the actor first
    /// No news of an action that began then gets to this participant (from 1) sooner. Time 0 is
    /// the first action's.
    std::function<Duration(std::size_t participant, Duration t)> leastDelay;
    StrategyKind strategy = StrategyKind::SessionClock; ///< that all were to run
};

struct LiveFigures {
    DriftFigures drift;          ///< without bytes and probes
    bool isEndStateSame = false; ///< both objects ended to the bit alike in all programs
    Duration handshakeMean{};    ///< over the participants
    Duration handshakeMax{};
    Duration gapP95{}; ///< between a program's samples: how long the machine let it wait
};

/// Compares what was shown, on CLOCK_MONOTONIC. The truth is the motion that the actor declared:
/// the script's axes and speeds, each action from where and when its actor began it, by that clock.
/// No estimate of the session's clock enters it, but for the few milliseconds between an action and
/// the actor's next sample.
///
/// @returns FileMalformed, naming who, where a log does not go from before the first action to the
///          end of the last, or is of another strategy.
[[nodiscard]] Result<LiveFigures> evaluateLive(const LiveRun& run);

} // namespace carina::lab
