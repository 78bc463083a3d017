#pragma once

#include "apps/lab/intubation/intubation_subject.h"
#include "engine/airway/monitor/intubation_monitor.h"
#include "engine/scoring/course/try_course.h"
#include "engine/session/body/tube_timeline.h"
#include "evaluation/intubation/motion_script.h"
#include "evaluation/intubation/motion_truth.h"
#include "evaluation/intubation/observed_motion.h"

namespace carina::lab
{

/// Session time at which a motion begins: late enough for what is done to a patient before.
inline constexpr SessionTime kTrialStart{std::chrono::seconds{300}};

/// One motion, what happened in it, and what was concluded from its observed poses.
struct IntubationTrial {
    MotionKind kind = MotionKind::Good;
    std::uint32_t seed = 1;
    MotionParameters parameters;
    MotionTruth truth;
    std::vector<MotionCommand> commands;
    std::vector<NotedStep> noted;       ///< in the order in which it was noted
    IntubationCourse course;            ///< in the end
    TryCourse measured{-Vec3::UnitY()}; ///< with blade and forces; the patient lies on the back
    Length registrationShare{}; ///< how far the registration's error moves the tip at the end
    Duration length{};

    [[nodiscard]] bool isWrong() const;
    [[nodiscard]] SessionTime end() const { return kTrialStart + length; }
    [[nodiscard]] std::vector<IntubationEvent> byTime() const; ///< what was noted
};

/// Runs a motion through tracker, registration, pose histories and monitor. The same arguments give
/// the same trial.
/// @returns the errors of scriptedMotion
[[nodiscard]] Result<IntubationTrial> runTrial(const IntubationSubject& subject, MotionKind kind,
                                               std::uint32_t seed,
                                               const ObservationSettings& observation = {});

/// The seat that the monitor is to tell.
[[nodiscard]] TubeSeat seatOf(TrueSeat truth);
/// The step that it is to note.
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
