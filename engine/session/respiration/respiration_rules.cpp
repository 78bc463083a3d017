#include "engine/session/respiration/respiration_rules.h"

#include "engine/session/facts/fact_rules.h"
#include "engine/session/facts/number_check.h"
#include "engine/session/respiration/respiration_timeline.h"

#include <limits>

namespace carina
{

namespace
{

// Of figures that a fold divides by, in SI units: far below any patient's, far above zero.
constexpr double kLeastVolume = 1e-7;
constexpr double kLeastPressure = 1e-2;
constexpr double kLeastCompliance = 1e-12;
// What no patient reaches, with any condition, setting or strength that people may choose.
constexpr double kLargestGas = 0.05;         // m^3: the largest total capacity is 11 L
constexpr double kMostInspired = 1.0;        // m^3, in a breath
constexpr double kGreatestPressure = 1e6;    // Pa
constexpr double kGreatestCompliance = 1e-4; // m^3/Pa: an adult's chest has 1e-6
constexpr double kGreatestResistance = 1e12;

Result<void> checkLung(const LungMechanics& lung)
{
    return checkNumbers({
        {"floor of a lung", lung.curve.floor.si, 0.0, kLargestGas, " m3"},
        {"span of a lung", lung.curve.span.si, kLeastVolume, kLargestGas, " m3"},
        {"centre of a lung's curve", lung.curve.centre.si, -kGreatestPressure, kGreatestPressure,
         " Pa"},
        {"width of a lung's curve", lung.curve.width.si, kLeastPressure, kGreatestPressure, " Pa"},
        {"pressure between limbs", lung.limbSpread.si, 0.0, kGreatestPressure, " Pa"},
        {"volume between limbs", lung.limbVolume.si, kLeastVolume, kLargestGas, " m3"},
        {"conductance of bronchi", lung.bronchi.si, 0.0, 1e-3, " m3/(Pa s)"},
        {"compression of bronchi", lung.compression, 1.0, 100.0, ""},
        {"closing volume", lung.closing.si, 0.0, kLargestGas, " m3"},
        {"compliance of a chest wall", lung.wall.si, kLeastCompliance, kGreatestCompliance,
         " m3/Pa"},
        {"resting volume", lung.wallVolume.si, kLeastVolume, kLargestGas, " m3"},
        {"recoil of a chest wall", lung.wallRecoil.si, -kGreatestPressure, kGreatestPressure,
         " Pa"},
        {"drive of the muscles", lung.drive, 0.0, 10.0, ""},
        {"gas in a pleura", lung.pleuralGas.si, 0.0, kLargestGas, " m3"},
        {"conductance of a tear", lung.valve.si, 0.0, 1e-3, " m3/(Pa s)"},
        {"relief of a pleura", lung.relief.si, 0.0, 10.0, " /s"},
        {"uptake by the blood", lung.uptake.si, 0.0, 10.0, " /s"},
        {"end of uptake", lung.uptakeEnd.si, 0.0, kLargestGas, " m3"},
        {"alveolar dead space", lung.alveolarDeadSpace.si, 0.0, kLargestGas, " m3"},
    });
}

Result<void> checkSystem(const RespiratorySystem& system)
{
    for (const LungMechanics& lung : system.lungs) {
        if (const Result<void> verdict = checkLung(lung); !verdict)
            return verdict;
    }
    return checkNumbers({
        {"resistance of an airway", system.upperLaminar.si, 0.0, kGreatestResistance, " Pa s/m3"},
        {"turbulence of an airway", system.upperTurbulent, 0.0, 1e15, " Pa s2/m6"},
        {"compliance of a mediastinum", system.mediastinum.si, 0.0, kGreatestCompliance, " m3/Pa"},
        {"room of a mediastinum", system.mediastinumMost.si, 0.0, kLargestGas, " m3"},
        {"weight of a mediastinum", system.mediastinalWeight.si, -kGreatestPressure,
         kGreatestPressure, " Pa"},
        {"anatomical dead space", system.anatomicalDeadSpace.si, 0.0, kLargestGas, " m3"},
        {"share of effort", system.effort, 0.0, 10.0, ""},
        {"strength of muscles", system.strength, 0.0, 10.0, ""},
        {"ratio of inspiration", system.inspiratoryRatio, 0.01, 100.0, ""},
        {"sag", system.sag, -1.0, 1.0, ""},
    });
}

/// A step of the integrator may end a little beyond the last of trapped gas.
Result<void> checkContent(const ChestContent& content)
{
    for (const LungContent& lung : content) {
        const Result<void> verdict = checkNumbers({
            {"gas in a lung", lung.gas.si, 0.0, kLargestGas, " m3"},
            {"place between limbs", lung.limb, 0.0, 1.0, ""},
            {"trapped gas", lung.trapped.si, -1e-9, kLargestGas, " m3"},
        });
        if (!verdict)
            return verdict;
    }
    return {};
}

/// Effort and opening of the present breath.
Result<void> checkDrive(const RespiratoryState& state)
{
    return checkNumbers({
        {"effort", state.effort.si, 0.0, kGreatestPressure, " Pa"},
        {"pressure of muscles", state.muscle.si, -kGreatestPressure, kGreatestPressure, " Pa"},
        {"pressure at the opening", inCmH2O(state.opening.pressure), 0.0,
         inCmH2O(kHighestPressureLimit), " cmH2O"},
        {"flow at the opening", inLitresPerSecond(state.opening.flow), 0.0, 1000.0, " L/s"},
    });
}

Result<void> checkTally(const BreathTally& tally)
{
    return checkNumbers({
        {"inspired volume", tally.inspired.si, 0.0, kMostInspired, " m3"},
        {"least gas, right", tally.least[0].si, 0.0, kLargestGas, " m3"},
        {"least gas, left", tally.least[1].si, 0.0, kLargestGas, " m3"},
        {"most gas, right", tally.most[0].si, 0.0, kLargestGas, " m3"},
        {"most gas, left", tally.most[1].si, 0.0, kLargestGas, " m3"},
        {"peak", tally.peak.si, -kGreatestPressure, kGreatestPressure, " Pa"},
        {"plateau", tally.plateau.si, -kGreatestPressure, kGreatestPressure, " Pa"},
    });
}

Result<void> checkFigures(const BreathFigures& last)
{
    return checkNumbers({
        {"tidal volume breathed", last.tidalVolume.si, 0.0, kMostInspired, " m3"},
        {"volume of the right lung", last.tidalVolumeOfLung[0].si, 0.0, kLargestGas, " m3"},
        {"volume of the left lung", last.tidalVolumeOfLung[1].si, 0.0, kLargestGas, " m3"},
        {"rate breathed", last.rate.si, 0.0, 1.0 / kRespiratoryStep, " /s"},
        {"peak of a breath", last.peak.si, -kGreatestPressure, kGreatestPressure, " Pa"},
        {"plateau of a breath", last.plateau.si, -kGreatestPressure, kGreatestPressure, " Pa"},
        {"end-expiratory pressure", last.endExpiratory.si, -kGreatestPressure, kGreatestPressure,
         " Pa"},
        {"auto-PEEP", last.autoPeep.si, -kGreatestPressure, kGreatestPressure, " Pa"},
        {"alveolar ventilation", last.alveolarVentilation.si, 0.0, 1.0, " m3/s"},
    });
}

Result<void> checkBreath(const BreathingPattern& breath)
{
    // In apnoea there is no breath.
    const Result<void> rate =
        breath.rate.si == 0.0 ? Result<void>{} : checkBody(fact::BreathingRateSet{breath.rate});
    return rate.and_then([&] { return checkBody(fact::TidalVolumeSet{breath.tidalVolume}); })
        .and_then(
            [&] { return checkBody(fact::InspiratoryFractionSet{breath.inspiratoryFraction}); });
}

Result<void> checkDriveState(const DriveState& drive)
{
    return checkNumbers({
        {"carbon dioxide", drive.carbonDioxide, 0.0, kMostCarbonDioxide, ""},
        {"tiredness", drive.tiredness, 0.0, 1.0, ""},
    });
}

/// Steps of half a million years, at most.
Result<void> checkSteps(const char* what, std::int64_t steps)
{
    constexpr double kMost = 9e15;
    return checkNumber(what, static_cast<double>(steps), 0.0, kMost, "");
}

Result<void> checkClock(const BreathClock::State& clock)
{
    return checkNumbers({
        {"breaths", clock.breaths, 0.0, 1e12, ""},
        {"rate of a clock", inPerMinute(clock.rate), 0.0, 100.0, " /min"},
        {"measured rate", inPerMinute(clock.measured), 0.0, 100.0, " /min"},
        {"breaths to catch up", clock.pull, -0.5, 0.5, ""},
        {"time since a breath", clock.sinceTrigger, -60.0, 1e9, " s"},
    });
}

} // namespace

Result<void> checkRespiration(const fact::PatientBuildSet& fact)
{
    return checkNumbers({
        {"height", inMillimetres(fact.build.height), inMillimetres(kSmallestPatient),
         inMillimetres(kTallestPatient), " mm"},
        {"weight", fact.build.weightInKilograms, kLightestPatient, kHeaviestPatient, " kg"},
        {"age", fact.build.ageInYears, kYoungestPatient, kOldestPatient, " years"},
    });
}

Result<void> checkRespiration(const fact::LungConditionsSet& fact)
{
    for (const LungCondition& condition : fact.conditions) {
        if (condition.kind == ConditionKind::MainstemIntubation
            && condition.side == ConditionSide::Both)
            return fail(Errc::OutOfRange, "a tube in both main bronchi");
        if (const auto verdict = checkNumber("severity", condition.severity, 0.0, 1.0, "");
            !verdict)
            return verdict;
    }
    if (!canCoexist(fact.conditions))
        return fail(Errc::OutOfRange, "too many conditions, or one twice on a lung");
    return {};
}

Result<void> checkRespiration(const fact::VentilatorSet& fact)
{
    const VentilatorSettings& settings = fact.settings;
    if (settings.ownRate.si != 0.0) {
        const Result<void> rate = checkBody(fact::BreathingRateSet{settings.ownRate});
        if (!rate)
            return rate;
    }
    const Result<void> numbers = checkNumbers({
        {"PEEP", inCmH2O(settings.peep), 0.0, inCmH2O(kHighestPeep), " cmH2O"},
        {"driving pressure", inCmH2O(settings.drivingPressure), 0.0,
         inCmH2O(kHighestDrivingPressure), " cmH2O"},
        {"pressure limit", inCmH2O(settings.pressureLimit), inCmH2O(kLowestPressureLimit),
         inCmH2O(kHighestPressureLimit), " cmH2O"},
        {"pause", settings.pauseShare, 0.0, kLongestPause, ""},
        {"trigger", inLitresPerSecond(settings.trigger), 0.0, inLitresPerSecond(kLargestTrigger),
         " L/s"},
        {"own effort", settings.ownEffort, 0.0, kStrongestEffort, ""},
    });
    if (numbers && settings.pressureLimit <= settings.peep)
        return fail(Errc::OutOfRange, "a pressure limit that is not above PEEP");
    return numbers;
}

Result<void> checkTubeSize(Length innerDiameter)
{
    if (innerDiameter.si == 0.0)
        return {};
    return checkNumber("tube", inMillimetres(innerDiameter), inMillimetres(kNarrowestTube),
                       inMillimetres(kWidestTube), " mm");
}

Result<void> checkRespiration(const fact::TubePlaced& fact)
{
    if (fact.tube.innerDiameter.si == 0.0 && fact.tube.seat != TubeSeat::None)
        return fail(Errc::OutOfRange, "a place of a tube that has no size");
    return checkTubeSize(fact.tube.innerDiameter);
}

Result<void> checkRespiration(const fact::BodyPositionSet&) { return {}; }

Result<void> checkRespiration(const fact::BreathingStopped& fact)
{
    return checkNumber("time over which breathing changes", toSeconds(fact.over), 0.0,
                       toSeconds(kLongestStopping), " s");
}

Result<void> checkRespiration(const fact::BagSqueezed& fact)
{
    const Result<void> volume = checkBody(fact::TidalVolumeSet{fact.bag.tidalVolume});
    if (!volume || fact.bag.rate.si == 0.0)
        return volume;
    return checkBody(fact::BreathingRateSet{fact.bag.rate});
}

Result<void> checkRespiration(const fact::ManikinBreathed&) { return {}; }

Result<void> checkRespiration(const fact::RespirationCheckpoint& fact)
{
    const RespiratoryState& state = fact.state;
    return checkSystem(state.system)
        .and_then([&] { return checkContent(state.content); })
        .and_then([&] { return checkDrive(state); })
        .and_then([&] { return checkTally(state.tally); })
        .and_then([&] { return checkFigures(state.last); })
        .and_then([&] { return checkBreath(state.breath); })
        .and_then([&] { return checkClock(state.clock); })
        .and_then([&] { return checkDriveState(state.drive); })
        .and_then([&] { return checkSteps("steps", state.steps); })
        .and_then([&] { return checkSteps("steps of a breath", state.tally.steps); })
        .and_then([&] { return checkSteps("ventilator steps", state.ventilator.sinceBreath); });
}

Result<void> checkTidalVolume(const PatientBuild& build, Volume tidalVolume)
{
    return checkNumber("tidal volume of this patient", inMillilitres(tidalVolume),
                       inMillilitres(kSmallestTidalVolume),
                       inMillilitres(largestTidalVolume(build)), " ml");
}

} // namespace carina
