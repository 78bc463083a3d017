#pragma once

#include "engine/physiology/body_state.h"

namespace carina
{

/// How a drug spreads: three linear compartments and an effect site. Rate constants per minute.
struct DrugKinetics {
    double central_LPerKg = 1.0;
    double eliminated = 0.0; ///< k10
    double toFast = 0.0;     ///< k12
    double fromFast = 0.0;   ///< k21
    double toSlow = 0.0;     ///< k13
    double fromSlow = 0.0;   ///< k31
    double toEffect = 0.0;   ///< ke0
};

/// Constants of a drug, per kilogram of the patient's weight at any age and build. Sources:
/// propofol Marsh et al., Br J Anaesth 1991;67:41, with the faster effect site of 1.2 per minute
/// (Struys, Anesthesiology 2000;92:399); ketamine Domino 1984; fentanyl Shafer 1990, for 70 kg;
/// rocuronium Wierda 1991, as printed by Masui (J Anesth 2018;32:709), with an effect site of ours;
/// suxamethonium, sugammadex and ephedrine: ours, fitted to onset and duration.
[[nodiscard]] const DrugKinetics& kineticsOf(DrugKind kind);

void inject(DrugsInBody& drugs, const DrugDose& dose);

/// All drugs after a step. A dose gets from the vein into the circulation with a time constant of
/// 12 s (ours), slower with less blood flow. Sugammadex encloses rocuronium, molecule for molecule
/// (4.1 mg to one), in the blood; while some of it is free, rocuronium leaves the effect site
/// faster (kReversal per minute, ours).
/// @param flow blood flow over that at rest
void spread(DrugsInBody& drugs, double weight_kg, double flow, double seconds);

[[nodiscard]] const DrugAmounts& amountsOf(const DrugsInBody& drugs, DrugKind kind);

/// Milligrams of sugammadex that enclose one of rocuronium: 2178 over 530 g/mol.
inline constexpr double kSugammadexPerRocuronium = 2178.0 / 530.0;
inline constexpr double kReversal = 1.0; ///< per minute

} // namespace carina
