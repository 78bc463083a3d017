#pragma once

#include "engine/anatomy/patient/patient_build.h"

namespace carina
{

/// What gas exchange and circulation take from a patient's build; at rest and in health.
struct BodyFigures {
    double weight_kg = 0.0;
    double oxygenUse_mlPerS = 0.0;     ///< awake; dry, at 0 degrees
    double carbonDioxide_mlPerS = 0.0; ///< made awake; likewise
    double cardiacOutput_mlPerS = 0.0;
    double bloodVolume_ml = 0.0;
    double haemoglobin_gPerL = 0.0;
    double heartRate_perMin = 0.0;
    double mean_mmHg = 0.0;
    double pulse_mmHg = 0.0;       ///< systolic less diastolic
    double openWhenStill = 1.0;    ///< share of the lungs' gas that closed airways leave in apnoea
    double restingVolume_ml = 0.0; ///< functional residual capacity

    friend bool operator==(const BodyFigures&, const BodyFigures&) = default;
};

/// Sources, [t] for textbook:
///
/// - Oxygen: asleep 0.82 times 10 kg^0.75 ml/min (Brody; a loss of 15 to 25 % in anaesthesia [t]);
///   in children 5.0 kg + 19.8 ml/min (Lindahl, Br J Anaesth 1989;62:70, measured in anaesthesia
///   from 3.6 to 25 kg), from 25 kg on no more than there, until the first is the greater. Awake as
///   much more as is lost in anaesthesia.
/// - Carbon dioxide: what the quiet breath of the mechanics carries away at 40 mmHg, as in
///   ventilatory_drive.h. It is 1.05 times the oxygen in an adult of usual weight, where 0.8 to 1
///   is normal [t], because that breath is larger than a person at rest needs.
/// - Cardiac output: 20 times the oxygen used awake, or 50 ml/L between artery and vein [t].
/// - Blood: 70 ml/kg [t], infants 80; fat adds 20 ml/kg (ours).
/// - Haemoglobin: 150 g/L in men, 135 in women, 115 at one year, 165 at birth [t].
/// - Heart rate at 0, 1/12, 1, 2, 6, 12 and 18 years: 127, 145, 123, 113, 91, 80, 72 per minute
///   (after Fleming, Lancet 2011;377:1011).
/// - Blood pressure: systolic 90 + 2 per year (APLS), 65 at birth and 80 at one month [t], up to
///   120 mmHg; diastolic two thirds of it.
/// - Airways close within the resting volume of a child below six years (Mansell et al., J Appl
///   Physiol 1972;33:711); how much they leave in apnoea is ours, so that the apnoea times of small
///   children come near those published.
[[nodiscard]] BodyFigures bodyFiguresOf(const PatientBuild& build);

/// What anaesthesia leaves of the oxygen used and the carbon dioxide made.
inline constexpr double kUseAsleep = 0.82;
/// Normal tension of carbon dioxide in arterial blood.
inline constexpr double kQuietCarbonDioxide_mmHg = 40.0;
/// Air pressure less that of water vapour at 37 degrees.
inline constexpr double kDryPressure_mmHg = 713.0;
/// A volume of gas dry at 0 degrees over what it has in the lungs: 713/760 times 273/310.
inline constexpr double kStandardPerBody = kDryPressure_mmHg / 760.0 * 273.15 / 310.15;

} // namespace carina
