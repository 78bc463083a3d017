#pragma once

#include "engine/session/respiration/patient_run.h"

#include <optional>

namespace carina
{

/// A patient, breathing and body, at times that mostly increase in small steps, as for drawing 60
/// times a second or plotting. The result is a pure function of the facts and the time; the object
/// only caches runs.
///
/// - For a later time it takes the steps in between: eight for a frame.
/// - It continues from the newest checkpoint, so that programs on different machines, whose
///   mathematical libraries round differently, never differ by more than ten seconds of rounding.
/// - A fact that arrives late (its effect time is before a time already computed) and a step back
///   in time are computed from a second, older run, or from the checkpoint.
class RespirationFollower
{
public:
    /// The patient at time t by the facts so far. The reference is valid until the next call.
    /// Always pass the same timeline; it may have grown since the last call.
    const PatientRun& at(const RespirationTimeline& timeline, SessionTime t);

private:
    /// A run, and the facts that it contains.
    struct Place {
        PatientRun run;
        SessionTime checkpoint{};  ///< from which the run started
        std::size_t decisions = 0; ///< number of timeline decisions that it contains
    };

    static Place begun(const RespirationTimeline& timeline, SessionTime t);
    static bool holds(const Place& place, const RespirationTimeline& timeline, SessionTime t);

    std::optional<Place> m_now;
    std::optional<Place> m_before; ///< older by up to kStepBack
};

/// Largest distance of the older run behind the newer one.
inline constexpr Duration kStepBack = std::chrono::milliseconds{500};

} // namespace carina
