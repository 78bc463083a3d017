#include "engine/session/body/body_rules.h"

#include "engine/session/facts/number_check.h"
#include "engine/session/respiration/respiration_rules.h"

#include <cmath>

namespace carina
{
namespace
{

// What no patient reaches, with any setting or dose that people may choose; all of ours.
constexpr double kMostGas_ml = 50'000.0;
constexpr double kMostShare = 2.0;             ///< of a gas, where nitrogen lacks
constexpr double kMostContent_mlPerL = 1000.0; ///< of oxygen in blood
constexpr double kMostTension_mmHg = 1e5;
constexpr double kMostPressure_mmHg = 1000.0;
constexpr double kMostRate_perS = 50.0;
constexpr double kLeastBeats_perS = 0.01; ///< of a heart that beats: its curves divide by it
constexpr double kMostDrug_mg = 1e9;
constexpr double kMostTime_s = 1e12;
constexpr double kMostBreathed_ml = 1e12; ///< in a breath that does not end
constexpr double kMostHarm = 1e9;         ///< it goes on after the heart has stopped
/// A step of an integrator may end a little beyond a bound.
constexpr double kBeyond = 1e-6;

struct CheckedShare {
    const char* what;
    double share;
};

Result<void> checkShares(std::initializer_list<CheckedShare> shares)
{
    for (const auto& [what, share] : shares)
        if (const auto verdict = checkNumber(what, share, -kBeyond, 1.0 + kBeyond, ""); !verdict)
            return verdict;
    return {};
}

Result<void> checkTension(const char* what, double tension_mmHg)
{
    return checkNumber(what, tension_mmHg, -kBeyond, kMostTension_mmHg, " mmHg");
}

Result<void> checkStepCount(const char* what, std::int64_t steps)
{
    constexpr double kMost = 9e15; // far more than half a million years of steps
    return checkNumber(what, static_cast<double>(steps), 0.0, kMost, "");
}

Result<void> checkGas(const AirwayGas& gas)
{
    for (const LungGas& lung : gas.lungs) {
        const Result<void> verdict = checkNumbers({
            {"oxygen in a lung", lung.oxygen_ml, -kBeyond, kMostGas_ml, " ml"},
            {"carbon dioxide in a lung", lung.carbonDioxide_ml, -kBeyond, kMostGas_ml, " ml"},
            // A lung that empties unevenly loses more of it than its share.
            {"nitrogen in a lung", lung.nitrogen_ml, -kMostGas_ml, kMostGas_ml, " ml"},
        });
        if (!verdict)
            return verdict;
    }
    for (const GasShares& cell : gas.airway)
        if (const auto verdict = checkNumbers({
                {"oxygen in an airway", cell.oxygen, -kBeyond, kMostShare, ""},
                {"carbon dioxide in an airway", cell.carbonDioxide, -kBeyond, kMostShare, ""},
            });
            !verdict)
            return verdict;
    return checkNumbers({
                            {"inhaled gas", gas.inhaled_ml, -kBeyond, kMostBreathed_ml, " ml"},
                            {"exhaled gas", gas.exhaled_ml, -kBeyond, kMostBreathed_ml, " ml"},
                        })
        .and_then([&] {
            return checkShares({{"open share of the gas", gas.openShare}});
        });
}

Result<void> checkBlood(const BloodGas& blood)
{
    return checkNumbers({
                            {"arterial oxygen", blood.arterialOxygen_mlPerL, -kBeyond,
                             kMostContent_mlPerL, " ml/L"},
                            {"venous oxygen", blood.venousOxygen_mlPerL, -kBeyond,
                             kMostContent_mlPerL, " ml/L"},
                            {"oxygen of slow blood", blood.restingOxygen_mlPerL, -kBeyond,
                             kMostContent_mlPerL, " ml/L"},
                        })
        .and_then([&] {
            return checkTension("arterial carbon dioxide", blood.arterialCarbonDioxide_mmHg);
        })
        .and_then([&] {
            return checkTension("carbon dioxide of tissues", blood.tissueCarbonDioxide_mmHg);
        })
        .and_then([&] {
            return checkTension("carbon dioxide of the right lung",
                                blood.lungCarbonDioxide_mmHg[0]);
        })
        .and_then([&] {
            return checkTension("carbon dioxide of the left lung", blood.lungCarbonDioxide_mmHg[1]);
        })
        .and_then([&] {
            return checkShares({{"constriction, right", blood.constriction[0]},
                                {"constriction, left", blood.constriction[1]}});
        });
}

Result<void> checkOximeter(const OximeterState& oximeter)
{
    for (const double saturation : oximeter.way)
        if (const auto verdict = checkShares({{"saturation on its way", saturation}}); !verdict)
            return verdict;
    return checkShares({{"saturation", oximeter.shown}}).and_then([&] {
        return checkStepCount("steps of an oximeter", oximeter.steps);
    });
}

Result<void> checkCirculation(const CirculationState& state)
{
    const double leastRate = state.heartRate_perS > 0.0 ? kLeastBeats_perS : 0.0;
    const double lastPhase = std::nextafter(1.0, 0.0); // the curves of the heart expect it below 1
    return checkNumbers(
               {
                   {"heart rate", state.heartRate_perS, leastRate, kMostRate_perS, " /s"},
                   {"phase of a beat", state.beat, 0.0, lastPhase, ""},
                   {"blood pressure", state.mean_mmHg, -kBeyond, kMostPressure_mmHg, " mmHg"},
                   {"pulse pressure", state.pulse_mmHg, -kBeyond, kMostPressure_mmHg, " mmHg"},
                   {"harm of the heart", state.harm, -kBeyond, kMostHarm, ""},
               })
        .and_then([&] {
            return checkShares(
                {{"response to a stimulus", state.alarm}, {"habituation", state.accustomed}});
        });
}

Result<void> checkDrugs(const DrugsInBody& drugs)
{
    for (const DrugAmounts& drug : drugs) {
        const Result<void> verdict = checkNumbers({
            {"drug in a vein", drug.vein_mg, -kBeyond, kMostDrug_mg, " mg"},
            {"drug in the blood", drug.central_mg, -kBeyond, kMostDrug_mg, " mg"},
            {"drug in tissues", drug.fast_mg, -kBeyond, kMostDrug_mg, " mg"},
            {"drug in slow tissues", drug.slow_mg, -kBeyond, kMostDrug_mg, " mg"},
            {"drug at its effect", drug.effect_mgPerL, -kBeyond, kMostDrug_mg, " mg/L"},
        });
        if (!verdict)
            return verdict;
    }
    return {};
}

Result<void> checkWay(const char* what, Length way, Length least)
{
    return checkNumber(what, inMillimetres(way), inMillimetres(least),
                       inMillimetres(kLongestTubeWay), " mm");
}

} // namespace

double mostMilligrams(DrugKind kind)
{
    switch (kind) {
    case DrugKind::Propofol:
    case DrugKind::Ketamine:
        return 1000.0;
    case DrugKind::Fentanyl:
        return 2.0;
    case DrugKind::Rocuronium:
    case DrugKind::Suxamethonium:
        return 500.0;
    case DrugKind::Sugammadex:
        return 5000.0;
    case DrugKind::Ephedrine:
        return 100.0;
    }
    return 0.0;
}

Result<void> checkPatientBody(const fact::GasSupplySet& fact)
{
    return checkNumber("inspired oxygen", fact.gas.inspiredOxygen, kRoomOxygen, kPureOxygen, "");
}

Result<void> checkPatientBody(const fact::DrugGiven& fact)
{
    const double most = mostMilligrams(fact.dose.kind);
    if (fact.dose.milligrams <= 0.0)
        return fail(Errc::OutOfRange, "a dose of nothing");
    return checkNumber("dose", fact.dose.milligrams, 0.0, most, " mg");
}

Result<void> checkPatientBody(const fact::TubeObstructed& fact)
{
    return checkNumber("obstruction of a tube", fact.share, 0.0, 1.0, "");
}

Result<void> checkPatientBody(const fact::IntubationNoted& fact)
{
    const IntubationEvent& event = fact.event;
    return checkNumber("confidence", event.confidence, 0.0, 1.0, "")
        .and_then([&] { return checkWay("depth at the teeth", event.depthAtTeeth, {}); })
        .and_then([&] {
            return checkWay("tip above the carina", event.tipAboveCarina, -1.0 * kLongestTubeWay);
        })
        .and_then([&] { return checkWay("distance of the two shapes", event.besides, {}); })
        .and_then([&] {
            return checkNumber("visible share of the glottis", event.glotticOpening, 0.0, 1.0, "");
        })
        .and_then([&] { return checkTubeSize(fact.innerDiameter); });
}

Result<void> checkPatientBody(const fact::CapnographCheckpoint& fact)
{
    const CapnographState& state = fact.state;
    for (const double tension : state.line)
        if (const auto verdict = checkTension("carbon dioxide in a line", tension); !verdict)
            return verdict;
    for (const double tension : {state.connector_mmHg, state.sensor_mmHg, state.highest_mmHg,
                                 state.lowest_mmHg, state.endTidal_mmHg, state.stomach_mmHg})
        if (const auto verdict = checkTension("carbon dioxide", tension); !verdict)
            return verdict;
    return checkNumbers({
        {"place in a line", static_cast<double>(state.next), 0.0, double(kSampleLine - 1), ""},
        {"rate by a capnograph", state.rate_perS, 0.0, kMostRate_perS, " /s"},
        {"time since a breath", state.sinceBreath_s, 0.0, kMostTime_s, " s"},
        {"phase of the stomach", state.stomachPhase, 0.0, 1.0 + kBeyond, ""},
    });
}

Result<void> checkPatientBody(const fact::BodyCheckpoint& fact)
{
    const BodyState& state = fact.state;
    return checkStepCount("steps of a body", state.steps)
        .and_then([&] { return checkGas(state.gas); })
        .and_then([&] { return checkBlood(state.blood); })
        .and_then([&] { return checkOximeter(state.oximeter); })
        .and_then([&] { return checkCirculation(state.circulation); })
        .and_then([&] { return checkDrugs(state.drugs); })
        .and_then([&] {
            return checkShares({{"spasm of the cords", state.spasm}});
        });
}

} // namespace carina
