#pragma once

#include "engine/lungs/mechanics/lung_dynamics.h"

#include <cstdint>

namespace carina
{

enum class VentilationMode : std::uint8_t { Spontaneous, VolumeControl, PressureControl };

/// Settings of the ventilator. Rate, tidal volume and inspiratory fraction are those of the
/// BreathingPattern beside it, also in spontaneous breathing.
struct VentilatorSettings {
    VentilationMode mode = VentilationMode::Spontaneous;
    Pressure peep = cmH2O(5.0);
    Pressure drivingPressure = cmH2O(10.0); ///< above PEEP; pressure control
    /// Volume control does not exceed this pressure; a limit below PEEP counts as PEEP.
    Pressure pressureLimit = cmH2O(40.0);
    /// Share of inspiration, at its end, during which no gas flows; volume control.
    double pauseShare = 0.2;
    VolumeFlow trigger;     ///< inspiratory flow that triggers a breath; 0: no triggering
    Frequency ownRate;      ///< of the patient's own efforts while ventilated; 0: none
    double ownEffort = 0.0; ///< of these efforts, as a share of that of a quiet breath

    friend bool operator==(const VentilatorSettings&, const VentilatorSettings&) = default;
};

/// A bag that is squeezed by hand, in place of a ventilator; rate 0: none. It leaves no pressure
/// between breaths, and gives way at the ventilator's pressure limit.
struct HandBag {
    Frequency rate;
    Volume tidalVolume = millilitres(300.0);

    friend bool operator==(const HandBag&, const HandBag&) = default;
};

/// Inspiration's share of a breath from the bag: 1:2.
inline constexpr double kBagInspiration = 1.0 / 3.0;

/// Pressure of the inspiratory muscles at a phase of the breath, as a share of its peak: a
/// half-sine rise over kRiseShare of inspiration; constant to the end of inspiration; a half-sine
/// fall over kFallShare of the duration of inspiration, or over all of expiration where that is
/// shorter.
/// @pre 0 <= phase < 1, the fraction within 0.1..0.9.
[[nodiscard]] double muscleShare(double phase, double inspiratoryFraction);

/// Pressure of the expiratory muscles of who coughs without a pause, at a time, as a share of its
/// peak: half a sine over kCoughBurst, and again after kCoughEvery.
/// @pre seconds are not negative
[[nodiscard]] double coughShare(double seconds);

// All of ours: in anaesthesia that is too light some coughs come in a breath, each of them less
// than the 100 cmH2O and more that awake people reach.
inline constexpr double kCoughEvery = 1.2; ///< s
inline constexpr double kCoughBurst = 0.4; ///< s
inline constexpr Pressure kCoughPressure = cmH2O(60.0);

/// Mean of muscleShare over a breath.
[[nodiscard]] double meanMuscleShare(double inspiratoryFraction);

inline constexpr double kRiseShare = 0.75;
inline constexpr double kFallShare = 0.5;

/// The peak muscle pressure with which a patient steadily breathes the tidal volume of a pattern,
/// to 0.1 % of that volume; found by simulating breaths.
/// @pre the rate is above 0.
[[nodiscard]] Pressure effortFor(const RespiratorySystem& system, const BreathingPattern& pattern);

/// State of a ventilator, counted in steps of the fold.
struct VentilatorState {
    std::int64_t sinceBreath = 0; ///< steps since its present breath began

    friend bool operator==(const VentilatorState&, const VentilatorState&) = default;
};

/// Durations within a ventilator's breath, in steps.
struct VentilatorTiming {
    std::int64_t flow = 1;        ///< of the flow phase of volume control
    std::int64_t inspiration = 1; ///< of flow and pause together
    std::int64_t breath = 2;
};

/// @param step length of a step, seconds
/// @pre the rate is above 0; pauseShare is in 0..1, below 1.
[[nodiscard]] VentilatorTiming ventilatorTiming(const VentilatorSettings& settings,
                                                const BreathingPattern& pattern, double step);

/// Boundary condition that the ventilator sets at the airway opening in its present step.
[[nodiscard]] AirwayOpening ventilatorOpening(const VentilatorSettings& settings,
                                              const VentilatorTiming& timing, Volume tidalVolume,
                                              const VentilatorState& state, double step);

/// Time after the end of inspiration from which on the patient's effort can trigger a breath.
inline constexpr double kTriggerDelay = 0.2; // s
/// Rise time of the pressure in pressure control.
inline constexpr double kPressureRise = 0.1; // s

} // namespace carina
