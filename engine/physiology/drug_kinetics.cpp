#include "engine/physiology/drug_kinetics.h"

#include <algorithm>

namespace carina
{
namespace
{

constexpr std::array<DrugKinetics, kDrugKinds.size()> kKinetics{{
    {0.228, 0.119, 0.112, 0.055, 0.0419, 0.0033, 1.2},         // propofol
    {0.063, 0.4381, 0.5921, 0.2470, 0.5900, 0.0146, 0.2},      // ketamine
    {6.09 / 70.0, 0.0827, 0.471, 0.102, 0.225, 0.0060, 0.147}, // fentanyl
    {0.044, 0.100, 0.210, 0.130, 0.028, 0.010, 0.13},          // rocuronium
    {0.040, 0.4, 0.0, 0.0, 0.0, 0.0, 0.45},                    // suxamethonium
    {0.050, 0.030, 0.12, 0.06, 0.0, 0.0, 0.0},                 // sugammadex
    {3.0, 0.03, 0.0, 0.0, 0.0, 0.0, 1.0},                      // ephedrine
}};

constexpr std::size_t placeOf(DrugKind kind) { return static_cast<std::size_t>(kind); }

bool isAbsent(const DrugAmounts& drug) { return drug == DrugAmounts{}; }

void spreadOne(DrugAmounts& drug, const DrugKinetics& kinetics, double weight_kg, double flow,
               double minutes)
{
    constexpr double kFromVein_perMin = 60.0 / 12.0;
    const double arriving = kFromVein_perMin * std::min(1.0, flow) * minutes * drug.vein_mg;
    const double fast = kinetics.toFast * drug.central_mg - kinetics.fromFast * drug.fast_mg;
    const double slow = kinetics.toSlow * drug.central_mg - kinetics.fromSlow * drug.slow_mg;
    const double concentration = drug.central_mg / (kinetics.central_LPerKg * weight_kg);
    drug.effect_mgPerL += minutes * kinetics.toEffect * (concentration - drug.effect_mgPerL);
    drug.vein_mg -= arriving;
    drug.central_mg += arriving - minutes * (fast + slow + kinetics.eliminated * drug.central_mg);
    drug.fast_mg += minutes * fast;
    drug.slow_mg += minutes * slow;
}

/// In the blood, at once.
void enclose(DrugAmounts& rocuronium, DrugAmounts& sugammadex, double minutes)
{
    const double bound =
        std::min(rocuronium.central_mg, sugammadex.central_mg / kSugammadexPerRocuronium);
    rocuronium.central_mg -= bound;
    sugammadex.central_mg -= kSugammadexPerRocuronium * bound;
    if (sugammadex.central_mg > 0.0)
        rocuronium.effect_mgPerL -= minutes * kReversal * rocuronium.effect_mgPerL;
}

} // namespace

const DrugKinetics& kineticsOf(DrugKind kind) { return kKinetics[placeOf(kind)]; }

const DrugAmounts& amountsOf(const DrugsInBody& drugs, DrugKind kind)
{
    return drugs[placeOf(kind)];
}

void inject(DrugsInBody& drugs, const DrugDose& dose)
{
    drugs[placeOf(dose.kind)].vein_mg += dose.milligrams;
}

void spread(DrugsInBody& drugs, double weight_kg, double flow, double seconds)
{
    const double minutes = seconds / 60.0;
    for (const DrugKind kind : kDrugKinds)
        if (DrugAmounts& drug = drugs[placeOf(kind)]; !isAbsent(drug))
            spreadOne(drug, kineticsOf(kind), weight_kg, flow, minutes);
    DrugAmounts& sugammadex = drugs[placeOf(DrugKind::Sugammadex)];
    if (!isAbsent(sugammadex))
        enclose(drugs[placeOf(DrugKind::Rocuronium)], sugammadex, minutes);
}

} // namespace carina
