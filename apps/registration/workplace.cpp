#include "apps/registration/workplace.h"

namespace carina
{

Result<Workplace> workplaceWith(const TrackerChoice& choice, const program::ChosenPatient& patient)
{
    if (const auto* device = std::get_if<SimulatedDevice>(&choice.device))
        return simulatedWorkplace(patient.model->landmarks(), patient.model->tube(),
                                  device->settings)
            .map([&](SimulatedWorkplace simulated) {
                const ReadSessionClock clock = simulated.clock;
                return Workplace{trackerName(choice), clock, std::move(simulated), {}};
            });
    return makeTracker(choice, workplaceNow).map([&](std::unique_ptr<Tracker> device) {
        const QString known = trackerIdentity(choice);
        return Workplace{
            known.isEmpty() ? trackerName(choice) : known, workplaceNow, {}, std::move(device)};
    });
}

} // namespace carina
