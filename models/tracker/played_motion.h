#pragma once

#include "engine/session/facts/facts.h"
#include "engine/session/simulated_station.h"
#include "models/patient/patient_model.h"

#include <functional>
#include <string>
#include <vector>

namespace carina
{

/// What the hands of a simulated tracker do once, in place of inserting the tube again and again.
struct PlayedMotion {
    /// What who holds the tube does by a control meanwhile.
    struct Control {
        Duration at{}; ///< from the start
        FactBody body;
    };

    /// At a time from the start, not negative; held beyond the end. For several threads.
    std::function<HandledTools(Duration)> at;
    std::vector<Control> controls; ///< in ascending order
    std::string laryngoscope;      ///< the tracker's name of it, which tells the blade
};

/// Finds the motion for a patient, with the tube that the patient has.
using PlayMotion = std::function<Result<PlayedMotion>(const PatientModel&)>;

} // namespace carina
