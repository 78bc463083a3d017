#include "engine/session/respiration_rules.h"

#include "engine/session/fact_rules.h"
#include "engine/session/number_check.h"

#include <initializer_list>
#include <limits>

namespace carina
{

namespace
{

struct CheckedNumber {
    const char* what;
    double value;
    double lowest;
    double highest;
    const char* unit;
};

/// The first that is out of its range.
Result<void> checkNumbers(std::initializer_list<CheckedNumber> numbers)
{
    for (const CheckedNumber& n : numbers) {
        const Result<void> verdict = checkNumber(n.what, n.value, n.lowest, n.highest, n.unit);
        if (!verdict)
            return verdict;
    }
    return {};
}

// Of figures that a fold divides by, in SI units: far below any patient's, far above zero.
constexpr double kLeastVolume = 1e-7;
constexpr double kLeastPressure = 1e-2;
constexpr double kLeastCompliance = 1e-12;
constexpr double kGreatest = 1e12;

Result<void> checkLung(const LungMechanics& lung)
{
    return checkNumbers({
        {"span of a lung", lung.curve.span.si, kLeastVolume, 1.0, " m3"},
        {"width of a lung's curve", lung.curve.width.si, kLeastPressure, kGreatest, " Pa"},
        {"volume between limbs", lung.limbVolume.si, kLeastVolume, 1.0, " m3"},
        {"conductance of bronchi", lung.bronchi.si, 0.0, 1e-3, " m3/(Pa s)"},
        {"compliance of a chest wall", lung.wall.si, kLeastCompliance, 1.0, " m3/Pa"},
        {"resting volume", lung.wallVolume.si, kLeastVolume, 1.0, " m3"},
        {"conductance of a tear", lung.valve.si, 0.0, 1e-3, " m3/(Pa s)"},
    });
}

Result<void> checkSystem(const RespiratorySystem& system)
{
    for (const LungMechanics& lung : system.lungs) {
        if (const Result<void> verdict = checkLung(lung); !verdict)
            return verdict;
    }
    return checkNumbers({
        {"resistance of an airway", system.upperLaminar.si, 0.0, kGreatest, " Pa s/m3"},
        {"turbulence of an airway", system.upperTurbulent, 0.0, 1e15, " Pa s2/m6"},
        {"compliance of a mediastinum", system.mediastinum.si, 0.0, 1.0, " m3/Pa"},
        {"room of a mediastinum", system.mediastinumMost.si, 0.0, 1.0, " m3"},
    });
}

Result<void> checkBreath(const BreathingPattern& breath)
{
    const Result<void> rate = checkBody(fact::BreathingRateSet{breath.rate});
    return rate.and_then([&] { return checkBody(fact::TidalVolumeSet{breath.tidalVolume}); })
        .and_then(
            [&] { return checkBody(fact::InspiratoryFractionSet{breath.inspiratoryFraction}); });
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
        {"breaths to catch up", clock.pull, -1.0, 1.0, ""},
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

Result<void> checkRespiration(const fact::LungConditionSet& fact)
{
    const LungCondition& condition = fact.condition;
    if (condition.kind == ConditionKind::MainstemIntubation
        && condition.side == ConditionSide::Both)
        return fail(Errc::OutOfRange, "a tube in both main bronchi");
    return checkNumber("severity", condition.severity, 0.0, 1.0, "");
}

Result<void> checkRespiration(const fact::VentilatorSet& fact)
{
    const VentilatorSettings& settings = fact.settings;
    if (settings.ownRate.si != 0.0) {
        const Result<void> rate = checkBody(fact::BreathingRateSet{settings.ownRate});
        if (!rate)
            return rate;
    }
    return checkNumbers({
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
}

Result<void> checkRespiration(const fact::TubePlaced& fact)
{
    if (fact.innerDiameter.si == 0.0)
        return {};
    return checkNumber("tube", inMillimetres(fact.innerDiameter), inMillimetres(kNarrowestTube),
                       inMillimetres(kWidestTube), " mm");
}

Result<void> checkRespiration(const fact::ManikinBreathed&) { return {}; }

Result<void> checkRespiration(const fact::RespirationCheckpoint& fact)
{
    const RespiratoryState& state = fact.state;
    return checkSystem(state.system)
        .and_then([&] { return checkBreath(state.breath); })
        .and_then([&] { return checkClock(state.clock); })
        .and_then([&] { return checkSteps("steps", state.steps); })
        .and_then([&] { return checkSteps("steps of a breath", state.tally.steps); })
        .and_then([&] { return checkSteps("ventilator steps", state.ventilator.sinceBreath); });
}

} // namespace carina
