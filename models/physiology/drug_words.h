#pragma once

#include "engine/core/units.h"
#include "engine/lungs/mechanics/tube_place.h"
#include "engine/physiology/drug.h"
#include "engine/physiology/gas_supply.h"

#include <QString>

namespace carina
{

/// "Propofol".
[[nodiscard]] QString drugText(DrugKind kind);
/// "Propofol 154 mg"; "Fentanyl 150 µg", as it is written on a syringe.
[[nodiscard]] QString doseText(const DrugDose& dose);

/// The unit in which people speak of a dose of this drug: " mg" or " µg".
[[nodiscard]] QString drugUnit(DrugKind kind);
/// How many of that unit are a milligram.
[[nodiscard]] double unitsPerMilligram(DrugKind kind);

/// Milligrams per kilogram that are usual for an intubation, from the information on the products
/// where they have one for it: propofol 2 and ketamine 2 for induction, fentanyl 0.002, rocuronium
/// 0.6 and suxamethonium 1 for relaxation, sugammadex 4 for reversal of a deep block, ephedrine
/// 0.1.
[[nodiscard]] double usualDose_mgPerKg(DrugKind kind);

/// "oxygen 100 %, mask held, probe on".
[[nodiscard]] QString gasText(const GasSupply& gas);
/// "in the right main bronchus".
[[nodiscard]] QString seatText(TubeSeat seat);
/// "in the trachea, 6.5 mm"; "as tracked".
[[nodiscard]] QString setTubeText(const SetTube& tube);

} // namespace carina
