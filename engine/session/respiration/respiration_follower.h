#pragma once

#include "engine/session/respiration/respiration_run.h"

#include <optional>

namespace carina
{

/// A RespirationRun for whoever asks again and again, usually for a little later: to draw a patient
/// 60 times a second, or to plot how it breathes. What it answers is a pure function of the facts
/// and the time; what it keeps makes the answer quick.
///
/// - Asked for later, it takes the steps between: eight for a frame.
/// - Stands on the newest checkpoint, so that programs on different machines, whose mathematical
///   libraries round differently, are never apart by more than ten seconds of rounding.
/// - A decision that comes too late (it counts from a time that was answered for already) and a
///   step back are made good from a second, older run, or from the checkpoint.
class RespirationFollower
{
public:
    /// The patient's breathing as the facts so far have it. The reference holds until the next
    /// call. `timeline` is always the same one, with facts that came since.
    const RespirationRun& at(const RespirationTimeline& timeline, SessionTime t);

private:
    /// Standing somewhere, knowing so much.
    struct Place {
        RespirationRun run;
        SessionTime checkpoint{}; ///< that it came from
        std::size_t decisions = 0;
    };

    static Place begun(const RespirationTimeline& timeline, SessionTime t);
    static bool holds(const Place& place, const RespirationTimeline& timeline, SessionTime t);

    std::optional<Place> m_now;
    std::optional<Place> m_before; ///< up to kStepBack ago
};

/// The older run is at most this far behind.
inline constexpr Duration kStepBack = std::chrono::milliseconds{500};

} // namespace carina
