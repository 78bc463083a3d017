#pragma once

#include "evaluation/intubation/motion_parameters.h"
#include "models/tracker/played_motion.h"

#include <QString>

#include <optional>

namespace carina::program
{

/// One of the motions of docs/intubation.md, as it is played in a session.
struct PlayedIntubation {
    MotionKind kind = MotionKind::Good;
    std::uint32_t seed = 1;
    Duration after{}; ///< how long the hands wait at first, for who prepares the patient

    friend bool operator==(const PlayedIntubation&, const PlayedIntubation&) = default;
};
inline constexpr Duration kLongestWait = std::chrono::minutes{10};

/// What is said of an intubation among the words of a simulated tracker, and the other words.
struct SimulatedWords {
    std::optional<PlayedIntubation> played;
    QString others; ///< separated by commas
};

/// Takes `intubation=SCRIPT`, `seed=N` and `after=SECONDS` out of words separated by commas.
/// @returns WrongOption for a script that there is not, and for the others without one
[[nodiscard]] Result<SimulatedWords> simulatedWordsIn(const QString& words);

/// "good, slow, oesophageal, ...".
[[nodiscard]] QString motionNames();

/// The parameters of this motion, as `carina-lab intubate` draws them for its seed.
[[nodiscard]] MotionParameters parametersOf(const PlayedIntubation& played);

/// The motion for a patient with the tube of a program, by who plays it: the tip of that tube goes
/// the patient's ways, and its cuff and stylet are set by controls. Once the cuff is inflated the
/// tip of the stylus listens at the chest (ListeningRound). A flexion of the neck is left out:
/// where the session lays the head, the hands go with it.
/// @returns from the motion: the errors of motionPatient
[[nodiscard]] PlayMotion playOf(const PlayedIntubation& played);

} // namespace carina::program
