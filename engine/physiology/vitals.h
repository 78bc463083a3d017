#pragma once

#include "engine/core/units.h"

#include <optional>

namespace carina
{

/// What a bedside monitor measures of a patient at a moment.
struct Vitals {
    double arterialSaturation = 0.0;  ///< true saturation of arterial blood, 0 to 1
    bool probeIsOn = false;           ///< the oximeter's, on the finger
    std::optional<double> saturation; ///< as the oximeter shows it, late; nothing without a pulse
    double pulseWave = 0.0;           ///< the oximeter's curve, 0 to 1
    std::optional<Pressure>
        exhaledCO2; ///< the capnograph's curve; nothing where it has no gas to sample
    std::optional<Pressure> endTidalCO2; ///< of the last breath; nothing before the first one
    /// Since the last breath by CO2 began, seconds of the patient's time; nothing before the first.
    std::optional<double> sinceBreath_s;
    Frequency capnographRate{}; ///< breaths by CO2; 0 without any
    Frequency heartRate{};      ///< 0: no beat
    Pressure systolic{};
    Pressure diastolic{};
    Pressure mean{};
    double electrocardiogram = 0.0; ///< lead II, millivolts

    friend bool operator==(const Vitals&, const Vitals&) = default;
};

} // namespace carina
