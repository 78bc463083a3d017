#pragma once

#include "apps/lab/intubation/watched_intubation.h"
#include "engine/physiology/vitals.h"

namespace carina::lab
{

/// What a bedside monitor measured at a time.
struct VitalsReading {
    SessionTime at{};
    Vitals vitals;
};

/// The patient of a trial, second by second from the start of its motion: three minutes on pure
/// oxygen by a mask before, induced and relaxed for the last one of these and ventilated by bag and
/// mask; without mask and breaths from the motion's start; and ventilated by a bag through the tube
/// while its hands do so, wherever it is. What the monitor noted takes effect when it was noted.
/// Doses, rate and volumes are of ours, usual ones for the weight.
///
/// @param until session time, not before kTrialStart
[[nodiscard]] std::vector<VitalsReading>
patientOf(const IntubationSubject& subject, const WatchedIntubation& watched, SessionTime until);

} // namespace carina::lab
