#pragma once

#include "apps/program/options/patient_option.h"
#include "apps/registration/simulated_workplace.h"
#include "models/tracker/tracker_choice.h"

namespace carina
{

/// The tracker that the stylus is touched under, and with it, where it is simulated, the manikin.
struct Workplace {
    QString name; ///< of the tracker, as shown and as the site names it
    ReadSessionClock clock;
    std::optional<SimulatedWorkplace> simulated{};
    std::unique_ptr<Tracker> device{};

    [[nodiscard]] Tracker& tracker() const { return device ? *device : *simulated->tracker; }
};

/// The workplace with this tracker, which is not started.
/// @returns the errors of makeTracker and simulatedWorkplace.
[[nodiscard]] Result<Workplace> workplaceWith(const TrackerChoice& choice,
                                              const program::ChosenPatient& patient);

} // namespace carina
