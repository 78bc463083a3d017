#include "engine/physiology/gas_exchange.h"

#include "engine/lungs/mechanics/ventilatory_drive.h"
#include "engine/physiology/airway_gas.h"
#include "engine/physiology/oxygen_dissociation.h"

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

constexpr double kArterialShare = 0.2;
constexpr std::array<double, 2> kFlowShare{0.525, 0.475};

/// Partial pressures in the alveoli of one lung that meet blood.
struct AlveolarTension {
    double oxygen_mmHg;
    double carbonDioxide_mmHg;
};

/// A lung that the blood empties of its gas collapses: below this share of its resting volume the
/// tensions fall with the gas.
AlveolarTension tensionOf(const LungGas& gas, double wasted, double resting_ml)
{
    constexpr double kLeastShare = 0.05;
    const double total = std::max(totalOf(gas), kLeastShare * resting_ml);
    const double carbonDioxide = kDryPressure_mmHg * gas.carbonDioxide_ml / total;
    return {kDryPressure_mmHg * gas.oxygen_ml / total, carbonDioxide / (1.0 - wasted)};
}

/// Shares of the cardiac output, after constriction.
std::array<double, 2> flowShares(const BloodGas& blood)
{
    std::array<double, 2> flow{};
    for (std::size_t i = 0; i < 2; ++i)
        flow[i] = kFlowShare[i] * (1.0 - kMostConstriction * blood.constriction[i]);
    const double sum = flow[0] + flow[1];
    return {flow[0] / sum, flow[1] / sum};
}

/// Hypoxic constriction follows the oxygen of a lung: half of it at 60 mmHg (ours).
void constrict(BloodGas& blood, std::size_t lung, double oxygen_mmHg, double seconds)
{
    constexpr double kHalf_mmHg = 60.0;
    const double ratio = oxygen_mmHg / kHalf_mmHg;
    const double target = 1.0 / (1.0 + ratio * ratio * ratio);
    blood.constriction[lung] += seconds / kConstrictionTime * (target - blood.constriction[lung]);
}

/// Share of their turnover that tissues keep up: less where the blood brings too little oxygen
/// (ours: below 30 ml/L in venous blood).
double keptUp(double venous_mlPerL)
{
    constexpr double kScarce_mlPerL = 30.0;
    return std::clamp(venous_mlPerL / kScarce_mlPerL, 0.0, 1.0);
}

/// Tissue and blood within a lung give carbon dioxide to its gas, or take it.
void buffer(LungGas& gas, double& tissue_mmHg, double alveolar_mmHg, double resting_ml,
            double seconds)
{
    constexpr double kTime = 0.3;
    const double flow_mmHg = seconds / kTime * (tissue_mmHg - alveolar_mmHg);
    tissue_mmHg -= flow_mmHg;
    gas.carbonDioxide_ml += std::max(kLungTissue * resting_ml * flow_mmHg / kDryPressure_mmHg,
                                     -0.2 * gas.carbonDioxide_ml);
}

/// Arteries, veins and slow vessels after a step in which the lungs gave blood of this content.
/// @param use share of the quiet turnover
void circulate(BloodGas& blood, const BodyFigures& body, const ExchangeConditions& conditions,
               double use, double fromLungs_mlPerL, double seconds)
{
    const double mixing_ml = kMixing * body.bloodVolume_ml;
    const double arterial_ml = kArterialShare * mixing_ml;
    const double flow_ml = conditions.cardiacOutput_mlPerS * seconds;
    const double slow_ml = kSlowFlow * flow_ml;
    const double used_ml = use * body.oxygenUse_mlPerS * seconds;
    const double arterial = blood.arterialOxygen_mlPerL;
    const double venous = blood.venousOxygen_mlPerL;
    const double resting = blood.restingOxygen_mlPerL;
    blood.arterialOxygen_mlPerL += flow_ml / arterial_ml * (fromLungs_mlPerL - arterial);
    blood.venousOxygen_mlPerL =
        std::max(0.0, venous
                          + ((flow_ml - slow_ml) * (arterial - venous)
                             + slow_ml * (resting - venous) - 1e3 * (1.0 - kSlowFlow) * used_ml)
                                / (mixing_ml - arterial_ml));
    blood.restingOxygen_mlPerL =
        std::max(0.0, resting
                          + (slow_ml * (arterial - resting) - 1e3 * kSlowFlow * used_ml)
                                / (body.bloodVolume_ml - mixing_ml));
}

} // namespace

void exchange(AirwayGas& gas, BloodGas& blood, const BodyFigures& body,
              const ExchangeConditions& conditions, double seconds)
{
    const std::array<double, 2> share = flowShares(blood);
    const double venousO2 = blood.venousOxygen_mlPerL;
    const double venousCO2 = blood.tissueCarbonDioxide_mmHg;
    // Of carbon dioxide per mmHg: what an artery-to-vein difference of quiet size carries.
    const double carried = body.carbonDioxide_mlPerS / kVenousExcess_mmHg
                           * conditions.cardiacOutput_mlPerS / body.cardiacOutput_mlPerS;
    double mixedO2 = 0.0;
    double mixedCO2 = 0.0;
    double exhaledCO2_ml = 0.0;
    for (std::size_t i = 0; i < 2; ++i) {
        LungGas& lung = gas.lungs[i];
        const double resting_ml = kFlowShare[i] * body.restingVolume_ml;
        const AlveolarTension alveolar = tensionOf(lung, conditions.wasted[i], resting_ml);
        const double exposed = share[i] * (1.0 - conditions.shunt[i]);
        const double capillary = oxygenContent_mlPerL(alveolar.oxygen_mmHg, body.haemoglobin_gPerL);
        const double flow_ml = exposed * conditions.cardiacOutput_mlPerS * seconds;
        const double taken =
            std::min(1e-3 * flow_ml * (capillary - venousO2), 0.2 * lung.oxygen_ml);
        const double given =
            std::max(exposed * carried * (venousCO2 - alveolar.carbonDioxide_mmHg) * seconds,
                     -0.2 * lung.carbonDioxide_ml);
        lung.oxygen_ml -= taken / kStandardPerBody;
        lung.carbonDioxide_ml += given / kStandardPerBody;
        exhaledCO2_ml += given;
        mixedO2 += flow_ml > 0.0 ? exposed * (venousO2 + 1e3 * taken / flow_ml) : 0.0;
        mixedO2 += (share[i] - exposed) * venousO2;
        mixedCO2 += exposed * alveolar.carbonDioxide_mmHg + (share[i] - exposed) * venousCO2;
        constrict(blood, i, alveolar.oxygen_mmHg, seconds);
        buffer(lung, blood.lungCarbonDioxide_mmHg[i], alveolar.carbonDioxide_mmHg, resting_ml,
               seconds);
    }
    const double use = conditions.use * keptUp(venousO2);
    circulate(blood, body, conditions, use, mixedO2, seconds);
    constexpr double kWithoutLungs = 0.9; // of the store, whose lungs are counted above
    const double store_mlPerMmHg =
        kWithoutLungs * body.carbonDioxide_mlPerS * kStoreTime / kQuietCarbonDioxide_mmHg;
    blood.arterialCarbonDioxide_mmHg = mixedCO2;
    blood.tissueCarbonDioxide_mmHg +=
        (use * body.carbonDioxide_mlPerS * seconds - exhaledCO2_ml) / store_mlPerMmHg;
}

GasShares quietAlveolar()
{
    constexpr double kOxygen_mmHg = 105.0;
    return {kOxygen_mmHg / kDryPressure_mmHg, kQuietCarbonDioxide_mmHg / kDryPressure_mmHg};
}

BloodGas quietBlood(const BodyFigures& body)
{
    BloodGas blood;
    blood.arterialOxygen_mlPerL = oxygenContent_mlPerL(95.0, body.haemoglobin_gPerL);
    blood.venousOxygen_mlPerL =
        blood.arterialOxygen_mlPerL - 1e3 * body.oxygenUse_mlPerS / body.cardiacOutput_mlPerS;
    blood.restingOxygen_mlPerL = blood.venousOxygen_mlPerL;
    blood.tissueCarbonDioxide_mmHg = kQuietCarbonDioxide_mmHg + kVenousExcess_mmHg;
    return blood;
}

double arterialSaturation(const BloodGas& blood, const BodyFigures& body)
{
    return oxygenSaturation(oxygenPressureOf(blood.arterialOxygen_mlPerL, body.haemoglobin_gPerL));
}

} // namespace carina
