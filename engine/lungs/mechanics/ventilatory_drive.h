#pragma once

#include "engine/core/units.h"

namespace carina
{

/// What makes a patient breathe harder, and tires the muscles.
struct DriveState {
    /// Arterial CO2 tension, as a multiple of that of quiet breathing in health.
    double carbonDioxide = 1.0;
    double tiredness = 0.0; ///< of the inspiratory muscles: 0 fresh to 1 exhausted

    friend bool operator==(const DriveState&, const DriveState&) = default;
};

/// Carbon dioxide after a time in which the patient had this alveolar ventilation and needed
/// `wanted`, that of quiet breathing: one store of the time constant kStoreTime, filled by a
/// constant production and emptied by ventilation. In apnoea the tension rises by a tenth (4 mmHg)
/// in a minute.
/// @pre wanted is above 0.
[[nodiscard]] double carbonDioxideAfter(double seconds, double before, VolumeFlow wanted,
                                        VolumeFlow alveolar);

/// Rate that the carbon dioxide drives, as a multiple of the quiet one: it rises by a quarter as
/// much as the effort (ours), up to kMostRate.
[[nodiscard]] double drivenRate(const DriveState& state);

/// Muscular effort that the carbon dioxide drives, as a multiple of that of quiet breathing in
/// health. It rises with the tension (kDriveGain), up to half of the pressure that the muscles can
/// generate (ours). Tired muscles give less, down to the effort of exhausted ones.
/// @param quiet peak muscle pressure of a quiet breath in health
/// @param strength share of kGreatestInspiratoryPressure that fresh muscles can generate
/// @param exhausted effort of exhausted muscles, as a share of `quiet`
[[nodiscard]] double drivenEffort(const DriveState& state, Pressure quiet, double strength,
                                  double exhausted);

/// Tiredness after a time of breathing. The tension-time index is the muscles' mean pressure over
/// what they can generate. Above 0.15 they are exhausted after 0.1 min / index^3.6 (Bellemare and
/// Grassino, J Appl Physiol 1982;53:1190); tired muscles can generate less, so that this runs on by
/// itself. They recover in kRecovery while the index is not above 0.15 and carbon dioxide is below
/// kRecoveringCarbonDioxide, because hypercapnia weakens the diaphragm (Juan et al., N Engl J Med
/// 1984;310:874); ventilation matters only by the carbon dioxide it leaves.
/// @param mean pressure of the inspiratory muscles, averaged over whole breaths
[[nodiscard]] double tirednessAfter(double seconds, const DriveState& before, Pressure mean,
                                    double strength);

/// What fresh inspiratory muscles can generate: about 100 cmH2O in adults and children from seven
/// years on (textbooks give 70 to 130).
inline constexpr Pressure kGreatestInspiratoryPressure = cmH2O(100.0);
/// 4 mmHg per minute of apnoea, of 40.
inline constexpr double kStoreTime = 600.0; // s
/// Rise of the effort per relative rise of CO2 tension: the mouth occlusion pressure rises by 0.3
/// cmH2O/mmHg from 1 cmH2O in CO2 rebreathing (textbooks give 0.2 to 0.6).
inline constexpr double kDriveGain = 12.0;
/// Relative rise of CO2 tension without response; so that rounding drives nobody (ours).
inline constexpr double kDriveThreshold = 0.02;
inline constexpr double kMostRate = 2.2; ///< 35 per minute in an adult (ours)
inline constexpr double kMostCarbonDioxide = 4.0;
inline constexpr double kFatigueIndex = 0.15;
inline constexpr double kRecovery = 900.0; ///< s (ours)
/// CO2 tension below which tired muscles recover, as a multiple of the quiet one (ours).
inline constexpr double kRecoveringCarbonDioxide = 1.1;

} // namespace carina
