#pragma once

#include "engine/physiology/body_figures.h"
#include "engine/physiology/body_state.h"

namespace carina
{

/// What acts on heart and vessels.
struct CirculatoryLoad {
    double saturation = 1.0;      ///< of arterial blood
    double bladeStimulus = 0.0;   ///< 0 to 1
    double tubeStimulus = 0.0;    ///< 0 to 1; the patient gets used to it
    double analgesia = 0.0;       ///< 0 to 1, dulls both
    double pressureByDrugs = 1.0; ///< factors on the mean pressure and the heart rate
    double rateByDrugs = 1.0;
    double tension = 0.0; ///< gas trapped in the pleura over twice the lungs' resting volume
};

/// Heart rate and blood pressure: simple, made for training, and no model of a circulation. Every
/// figure without a source is ours.
///
/// - A stimulus of the airway raises the rate by kAlarmRate and the pressure by kAlarmPressure
///   within half a minute; it fades over some minutes (a rise of 20 to 30 % in textbooks).
/// - Lack of oxygen: faster from 94 % down, by a quarter at 80 %; slower below 68 %.
/// - The heart takes harm below 60 %, and with a pressure below 0.4 of the normal one, and stops in
///   the end. It does not start again: the model has no resuscitation.
/// - Gas under tension in the pleura obstructs the venous return: the pressure falls by 0.6 and the
///   rate rises by 0.7 when it is twice what the lungs hold at rest.
void advance(CirculationState& state, const BodyFigures& body, const CirculatoryLoad& load,
             double seconds);

[[nodiscard]] CirculationState quietCirculation(const BodyFigures& body);

/// Blood that the heart moves now.
[[nodiscard]] double cardiacOutput_mlPerS(const CirculationState& state, const BodyFigures& body);

inline constexpr double kAlarmRate = 0.28;
inline constexpr double kAlarmPressure = 0.30;

} // namespace carina
