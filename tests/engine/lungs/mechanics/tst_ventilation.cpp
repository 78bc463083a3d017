#include "engine/lungs/mechanics/ventilation.h"

#include "tests/engine/lungs/drawing/chest_samples.h"
#include "tests/engine/lungs/mechanics/within.h"
#include "tests/support/test_class.h"

#include <algorithm>

namespace carina::ventilation_test
{

using namespace carina::test;

namespace
{

constexpr double kBreathTolerance_cmH2O = 1e-4;

/// 4 s of which 1 s is inspiration, a fifth of that pause.
BreathingPattern fifteenPerMinute() { return {perMinute(15.0), litres(0.5), 0.25}; }

VentilatorSettings ventilator(VentilationMode mode)
{
    VentilatorSettings settings;
    settings.mode = mode;
    settings.peep = cmH2O(5.0);
    settings.drivingPressure = cmH2O(12.0);
    return settings;
}

/// Lungs under a ventilator, step by step.
struct Bench {
    RespiratorySystem system;
    VentilatorSettings settings;
    BreathingPattern pattern = fifteenPerMinute();
    ChestContent content = restingContent(system);
    VentilatorState state{};
    ChestMoment moment{};

    void step()
    {
        const VentilatorTiming timing = ventilatorTiming(settings, pattern, kStep);
        if (state.sinceBreath >= timing.breath)
            state.sinceBreath = 0;
        const AirwayOpening opening =
            ventilatorOpening(settings, timing, pattern.tidalVolume, state, kStep);
        content = advanced(system, content, kRelaxed, opening, kStep);
        moment = chestMoment(system, content, {}, opening);
        ++state.sinceBreath;
    }
    void steps(int count)
    {
        for (int i = 0; i < count; ++i)
            step();
    }
};

} // namespace

class TestVentilation : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void musclesPullByHalfSines();
    void musclesRelaxByTheEndOfALongInspiration();
    void findsTheEffortOfStraightLungs();
    void pullsMoreWhereABreathHasNoTimeForItsVolume();
    void dividesABreathIntoSteps();
    void deliversTheVolumeAtConstantFlow();
    void showsResistanceAndComplianceAtTheOpening();
    void stopsAtThePressureLimit();
    void takesALimitBelowPeepForPeep();
    void risesToItsPressureAndHolds();
    void holdsPeepInExpiration();
    void trapsWhatHasNoTimeToLeave();
};

/// Up over three quarters of inspiration, held, down over half as long as inspiration.
void TestVentilation::musclesPullByHalfSines()
{
    QCOMPARE(muscleShare(0.0, 0.4), 0.0);
    VERIFY_WITHIN(muscleShare(0.1, 0.4), 0.25, 1e-12); // a third of the rise: (1 - cos 60 deg) / 2
    VERIFY_WITHIN(muscleShare(0.15, 0.4), 0.5, 1e-12);
    QCOMPARE(muscleShare(0.3, 0.4), 1.0);
    QCOMPARE(muscleShare(0.37, 0.4), 1.0);
    QCOMPARE(muscleShare(0.4, 0.4), 1.0);
    VERIFY_WITHIN(muscleShare(0.5, 0.4), 0.5, 1e-12);
    VERIFY_WITHIN(muscleShare(0.6, 0.4), 0.0, 1e-12);
    QCOMPARE(muscleShare(0.8, 0.4), 0.0);
}

void TestVentilation::musclesRelaxByTheEndOfALongInspiration()
{
    VERIFY_WITHIN(muscleShare(0.9, 0.8), 0.5, 1e-12);
    QVERIFY(muscleShare(0.999999, 0.8) < 1e-6);
}

/// Straight lungs without loops and with an airway that takes no time: VT / C.
void TestVentilation::findsTheEffortOfStraightLungs()
{
    const RespiratorySystem system = linear({.upper = 1e-3, .bronchi = 2e-3});
    VERIFY_WITHIN(inCmH2O(effortFor(system, fifteenPerMinute())), 10.0, 0.01);
    BreathingPattern none = fifteenPerMinute();
    none.tidalVolume = {};
    QCOMPARE(effortFor(system, none).si, 0.0);
}

/// Against the equation tau V' + V = muscle C, integrated here in small steps, breath after breath.
void TestVentilation::pullsMoreWhereABreathHasNoTimeForItsVolume()
{
    for (const double rate_perMin : {8.0, 19.0, 40.0}) {
        constexpr int kSteps = 100'000; // of a breath
        const RespiratorySystem system = linear({});
        const double tau = 6.0 * 0.05 / (60.0 / rate_perMin); // of a breath
        double volume = 0.0;                                  // of what the muscle would hold
        double least = 0.0;
        double most = 0.0;
        for (int i = 0; i < 10 * kSteps; ++i) {
            const double phase = (i % kSteps + 0.5) / kSteps;
            volume += (muscleShare(phase, 0.4) - volume) / kSteps / tau;
            least = i % kSteps == 0 ? volume : std::min(least, volume);
            most = i % kSteps == 0 ? volume : std::max(most, volume);
        }
        const BreathingPattern pattern{perMinute(rate_perMin), litres(0.5), 0.4};
        VERIFY_WITHIN(inCmH2O(effortFor(system, pattern)), 10.0 / (most - least), 0.02);
    }
}

void TestVentilation::dividesABreathIntoSteps()
{
    const auto timing =
        ventilatorTiming(ventilator(VentilationMode::VolumeControl), fifteenPerMinute(), kStep);
    QCOMPARE(timing.flow, 400);
    QCOMPARE(timing.inspiration, 500);
    QCOMPARE(timing.breath, 2000);
}

/// 0.5 L in 0.8 s, and a pause.
void TestVentilation::deliversTheVolumeAtConstantFlow()
{
    Bench bench{linear({}), ventilator(VentilationMode::VolumeControl)};
    bench.settings.peep = {};
    bench.steps(400);
    VERIFY_WITHIN(inLitresPerSecond(bench.moment.airwayFlow), 0.625, 1e-9);
    VERIFY_WITHIN(gasAboveRest_l(bench.system, bench.content), 0.5, kVolumeTolerance_l);
    bench.steps(100);
    VERIFY_WITHIN(inLitresPerSecond(bench.moment.airwayFlow), 0.0, 1e-9);
    VERIFY_WITHIN(gasAboveRest_l(bench.system, bench.content), 0.5, kVolumeTolerance_l);
    bench.steps(1);
    QVERIFY(bench.moment.airwayFlow.si < 0.0);
}

/// Peak VT/C + R Q, plateau VT/C: 10 + 6 * 0.625 and 10 cmH2O.
void TestVentilation::showsResistanceAndComplianceAtTheOpening()
{
    Bench bench{linear({}), ventilator(VentilationMode::VolumeControl)};
    bench.settings.peep = {};
    bench.steps(400);
    VERIFY_WITHIN(inCmH2O(bench.moment.opening), 13.75, kBreathTolerance_cmH2O);
    bench.steps(100);
    VERIFY_WITHIN(inCmH2O(bench.moment.opening), 10.0, kBreathTolerance_cmH2O);
}

void TestVentilation::stopsAtThePressureLimit()
{
    Bench bench{linear({}), ventilator(VentilationMode::VolumeControl)};
    bench.settings.peep = {};
    bench.settings.pressureLimit = cmH2O(8.0);
    double highest = 0.0;
    for (int i = 0; i < 400; ++i) {
        bench.step();
        highest = std::max(highest, inCmH2O(bench.moment.opening));
    }
    VERIFY_WITHIN(highest, 8.0, kBreathTolerance_cmH2O);
    QVERIFY(gasAboveRest_l(bench.system, bench.content) < 0.4);
}

/// A ventilator that may not go above PEEP gives nothing, and takes nothing either.
void TestVentilation::takesALimitBelowPeepForPeep()
{
    for (const double limit_cmH2O : {5.0, 2.0, 0.0}) {
        Bench bench{linear({}), ventilator(VentilationMode::VolumeControl)};
        bench.settings.pressureLimit = cmH2O(limit_cmH2O);
        bench.steps(5 * 2000 - 100); // PEEP comes in with the first expiration
        for (int i = 0; i < 2000; ++i) {
            bench.step();
            VERIFY_WITHIN(gasAboveRest_l(bench.system, bench.content), 0.25, kVolumeTolerance_l);
        }
    }
}

/// 12 cmH2O above PEEP in 0.1 s; the volume goes to 12 C.
void TestVentilation::risesToItsPressureAndHolds()
{
    Bench bench{linear({}), ventilator(VentilationMode::PressureControl)};
    bench.steps(26);
    VERIFY_WITHIN(inCmH2O(bench.moment.opening), 5.0 + 12.0 * 0.5, kBreathTolerance_cmH2O);
    bench.steps(25);
    VERIFY_WITHIN(inCmH2O(bench.moment.opening), 17.0, kBreathTolerance_cmH2O);
    bench.steps(449);
    VERIFY_WITHIN(inCmH2O(bench.moment.opening), 17.0, kBreathTolerance_cmH2O);
    bench.steps(1);
    VERIFY_WITHIN(inCmH2O(bench.moment.opening), 5.0, kBreathTolerance_cmH2O);
}

/// PEEP keeps PEEP C in the lungs.
void TestVentilation::holdsPeepInExpiration()
{
    Bench bench{linear({}), ventilator(VentilationMode::VolumeControl)};
    bench.steps(10 * 2000);
    const double remains = 0.5 * std::exp(-3.0 / 0.3) / (1.0 - std::exp(-3.0 / 0.3));
    VERIFY_WITHIN(gasAboveRest_l(bench.system, bench.content), 0.25 + remains, kVolumeTolerance_l);
    VERIFY_WITHIN(inCmH2O(bench.moment.alveolar[0]), 5.0 + remains / 0.05, kBreathTolerance_cmH2O);
}

/// In steady state VT e / (1 - e) stays behind, with e = exp(-T / RC): 30 cmH2O s/L and 0.05
/// L/cmH2O have 1.5 s, 3 s of expiration leave e = 0.135, and 0.078 L an auto-PEEP of 1.57 cmH2O.
void TestVentilation::trapsWhatHasNoTimeToLeave()
{
    LinearChest chest;
    chest.bronchi = 28.0;
    Bench bench{linear(chest), ventilator(VentilationMode::VolumeControl)};
    bench.settings.peep = {};
    bench.steps(30 * 2000);
    const double left = std::exp(-3.0 / 1.5);
    const double trapped_l = 0.5 * left / (1.0 - left);
    VERIFY_WITHIN(gasAboveRest_l(bench.system, bench.content), trapped_l, kVolumeTolerance_l);
    VERIFY_WITHIN(inCmH2O(bench.moment.alveolar[0]), trapped_l / 0.05, kBreathTolerance_cmH2O);
}

CARINA_TEST(TestVentilation)

} // namespace carina::ventilation_test

#include "tst_ventilation.moc"
