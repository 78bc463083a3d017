#include "apps/registration/workplace.h"

#include "engine/core/monotonic_clock.h"

namespace carina
{

Result<Workplace> workplaceWith(const TrackerChoice& choice, const program::ChosenPatient& patient)
{
    if (choice.isSimulated())
        return simulatedWorkplace(patient.model->landmarks(), patient.model->tube())
            .map([&](SimulatedWorkplace simulated) {
                const ReadSessionClock clock = simulated.clock;
                return Workplace{trackerName(choice), clock, std::move(simulated), {}};
            });
    const auto clock = [] { return std::optional{SessionTime{monotonicNow().time_since_epoch()}}; };
    return makeTracker(choice, clock).map([&](std::unique_ptr<Tracker> device) {
        return Workplace{trackerName(choice), clock, {}, std::move(device)};
    });
}

} // namespace carina
