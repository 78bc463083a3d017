#pragma once

#include "engine/lungs/mechanics/lung_dynamics.h"

#include <cstdint>

namespace carina
{

enum class VentilationMode : std::uint8_t { Spontaneous, VolumeControl, PressureControl };

/// What makes the breaths. Rate, tidal volume and inspiratory fraction are those of the
/// BreathingPattern beside it, whoever breathes.
struct VentilatorSettings {
    VentilationMode mode = VentilationMode::Spontaneous;
    Pressure peep = cmH2O(5.0);
    Pressure drivingPressure = cmH2O(10.0); ///< above PEEP, pressure control
    Pressure pressureLimit = cmH2O(40.0);   ///< volume control gives no more, nor less than PEEP
    double pauseShare = 0.2; ///< of inspiration, held without flow at its end, volume control
    VolumeFlow trigger;      ///< inspired flow that begins a breath early; 0: none does
    Frequency ownRate;       ///< of the patient's own efforts while ventilated; 0: none
    double ownEffort = 0.0;  ///< of these, as a share of a quiet breath's

    friend bool operator==(const VentilatorSettings&, const VentilatorSettings&) = default;
};

/// The share of its greatest effort that the inspiratory muscle makes at a phase of the breath: a
/// half sine up, from 0 to kRiseShare of inspiration; held to its end; a half sine down over
/// kFallShare of inspiration, or over all of expiration where that is shorter.
/// @pre 0 <= phase < 1, the fraction within 0.1..0.9.
[[nodiscard]] double muscleShare(double phase, double inspiratoryFraction);

inline constexpr double kRiseShare = 0.75;
inline constexpr double kFallShare = 0.5;

/// The muscle's greatest pressure with which a patient breathes the tidal volume of a pattern,
/// breath after breath, to a thousandth of it: found by breathing.
/// @pre the rate is above 0.
[[nodiscard]] Pressure effortFor(const RespiratorySystem& system, const BreathingPattern& pattern);

/// A ventilator's own clock, in steps of the fold.
struct VentilatorState {
    std::int64_t sinceBreath = 0; ///< steps since its present breath began

    friend bool operator==(const VentilatorState&, const VentilatorState&) = default;
};

/// A ventilator's breath in whole steps.
struct VentilatorTiming {
    std::int64_t flow = 1;        ///< gas is driven in
    std::int64_t inspiration = 1; ///< flow and pause
    std::int64_t breath = 2;
};

[[nodiscard]] VentilatorTiming ventilatorTiming(const VentilatorSettings& settings,
                                                const BreathingPattern& pattern, double step);

/// What the ventilator does to the airway in its present step.
[[nodiscard]] AirwayOpening ventilatorOpening(const VentilatorSettings& settings,
                                              const VentilatorTiming& timing, Volume tidalVolume,
                                              const VentilatorState& state, double step);

/// A patient's effort is looked for this long after the end of inspiration.
inline constexpr double kTriggerDelay = 0.2; // s
/// Pressure control reaches its pressure in this time.
inline constexpr double kPressureRise = 0.1; // s

} // namespace carina
