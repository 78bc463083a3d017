#pragma once

#include "apps/lab/intubation/watched_intubation.h"
#include "evaluation/intubation/motion_script.h"
#include "evaluation/intubation/motion_truth.h"
#include "evaluation/intubation/observed_motion.h"

namespace carina::lab
{

/// One motion, what happened in it, and what was concluded from its observed poses.
struct IntubationTrial : WatchedIntubation {
    MotionKind kind = MotionKind::Good;
    std::uint32_t seed = 1;
    MotionParameters parameters;
    MotionTruth truth;
    ObservedMotion seen; ///< by its times from the motion's start
    /// What the registration's error moves in the end: the tip, and the place at which the depth is
    /// read.
    Length registrationAtTip{};
    Length registrationAtTeeth{};

    [[nodiscard]] bool isWrong() const;
};

/// Runs a motion through tracker, registration, pose histories and monitor. The same arguments give
/// the same trial.
/// @returns the errors of scriptedMotion
[[nodiscard]] Result<IntubationTrial> runTrial(const IntubationSubject& subject, MotionKind kind,
                                               std::uint32_t seed,
                                               const ObservationSettings& observation = {});

/// The step that the monitor is to note.
[[nodiscard]] IntubationStep stepOf(TrueStep truth);

/// What the monitor noted compared with what happened, of the steps that it tells by poses.
struct StepErrors {
    std::vector<Duration> times; ///< noted less true
    std::vector<TrueStep> missed;
    std::vector<IntubationStep> invented;
};
/// Each true event and the one noted of its step within kSameEvent.
[[nodiscard]] StepErrors stepErrors(const IntubationTrial& trial);
inline constexpr Duration kSameEvent = std::chrono::seconds{1};

} // namespace carina::lab
