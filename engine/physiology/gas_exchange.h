#pragma once

#include "engine/physiology/body_figures.h"
#include "engine/physiology/body_state.h"

namespace carina
{

/// What the exchange of gas depends on in one step.
struct ExchangeConditions {
    double cardiacOutput_mlPerS = 0.0;
    double use = 1.0;               ///< share of the quiet turnover of oxygen and carbon dioxide
    std::array<double, 2> shunt{};  ///< share of each lung's blood that meets no gas
    std::array<double, 2> wasted{}; ///< share of each lung's gas that meets no blood
};

/// One step of the exchange between lungs, blood and tissues.
///
/// Oxygen is in the lungs' gas, in arterial blood (0.2 of the blood, kMixing of which takes part),
/// in venous blood, and in blood that turns over slowly. Blood leaves a lung in equilibrium with
/// its gas, but for the shunt. Blood flows to right and left as 0.525 to 0.475, less to a lung
/// without oxygen: its vessels constrict (kMostConstriction).
///
/// Carbon dioxide: tissues and venous blood are one store, at the tension of venous blood, with the
/// time constant kStoreTime of ventilatory_drive.h. Its content is taken as proportional to the
/// tension, so that a flow of quiet size needs kVenousExcess between vein and lung. Tissue and
/// blood within the lungs hold as much as kLungTissue times their resting gas does, and damp its
/// swing from breath to breath. It is made of oxygen: where the tissues lack that, as after the
/// heart has stopped, no more is made. What lactic acid then sets free from bicarbonate is not in
/// the model.
void exchange(AirwayGas& gas, BloodGas& blood, const BodyFigures& body,
              const ExchangeConditions& conditions, double seconds);

/// Quiet breathing of room air.
[[nodiscard]] GasShares quietAlveolar();
[[nodiscard]] BloodGas quietBlood(const BodyFigures& body);

/// True saturation of arterial blood, 0 to 1.
[[nodiscard]] double arterialSaturation(const BloodGas& blood, const BodyFigures& body);

/// Tension in venous less that in arterial blood at rest: 52 ml/L over 4.7 ml/L for each mmHg.
/// Textbooks have 6 mmHg, by the Haldane effect; in apnoea this effect vanishes, and the tension in
/// the lungs rises by all of the difference.
inline constexpr double kVenousExcess_mmHg = 11.0;
/// Some 600 g of tissue and 450 ml of blood in an adult hold 4 ml/mmHg, the gas 2.7 (estimate of
/// ours, with 3 and 5 ml/mmHg for a litre of tissue and blood).
inline constexpr double kLungTissue = 1.5;
/// Greatest loss of blood flow of a lung without oxygen, and its time constant (ours: textbooks
/// have half of the flow, within some minutes).
inline constexpr double kMostConstriction = 0.75;
inline constexpr double kConstrictionTime = 60.0; // s
/// Share of the blood whose oxygen the lungs see within a minute; the rest lies in vessels that are
/// flown through slowly (ours, so that the saturation falls from 90 to 70 % in some 40 s).
inline constexpr double kMixing = 0.65;
inline constexpr double kSlowFlow = 0.1; ///< of the cardiac output goes there (ours)

} // namespace carina
