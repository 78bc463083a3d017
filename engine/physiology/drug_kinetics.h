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

/// Constants of a drug, per kilogram of the patient's weight at any age and build. The three
/// compartments are those in use for target-controlled infusion under these names: propofol Marsh
/// (Br J Anaesth 1991;67:41), ketamine Domino, fentanyl Shafer for 70 kg, rocuronium Wierda, as
/// printed by Masui (J Anesth 2018;32:709). Effect sites: propofol 1.2 per minute, as is usual with
/// Marsh where a fast one is wanted; the others are ours. Suxamethonium, sugammadex and ephedrine:
/// ours, fitted to onset and duration.
[[nodiscard]] const DrugKinetics& kineticsOf(DrugKind kind);

void inject(DrugsInBody& drugs, const DrugDose& dose);

/// All drugs after a step. A dose gets from the vein into the circulation with a time constant of
/// 12 s (ours), slower with less blood flow. Sugammadex encloses rocuronium, molecule for molecule
/// (3.6 mg to one), in the blood; while some of it is free, rocuronium leaves the effect site
/// faster (kReversal per minute, ours).
/// @param flow blood flow over that at rest
void spread(DrugsInBody& drugs, double weight_kg, double flow, double seconds);

[[nodiscard]] const DrugAmounts& amountsOf(const DrugsInBody& drugs, DrugKind kind);

/// Milligrams of sugammadex that enclose one of rocuronium: 2178 over 610 g/mol, of the sodium salt
/// and the bromide, in which both are dosed (3.6 times: Kopman, Anesth Analg 2007;105:883).
inline constexpr double kSugammadexPerRocuronium = 2178.0 / 610.0;
inline constexpr double kReversal = 1.0; ///< per minute

} // namespace carina
