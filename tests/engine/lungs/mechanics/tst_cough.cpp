#include "engine/lungs/mechanics/respiratory_fold.h"
#include "tests/engine/lungs/mechanics/within.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <cmath>

namespace carina::cough_test
{

namespace
{

constexpr int kSecond = 500; // steps
constexpr PatientBuild kAdult{metres(1.75), 77.0, 40.0, Sex::Male};
constexpr PatientBuild kNewborn{metres(0.50), 3.3, 0.0, Sex::Female};

RespiratorySettings quiet(const PatientBuild& build)
{
    RespiratorySettings settings;
    settings.build = build;
    settings.pattern = restingPattern(build);
    return settings;
}

RespiratorySettings ventilated(const PatientBuild& build)
{
    RespiratorySettings settings = quiet(build);
    settings.ventilator.mode = VentilationMode::VolumeControl;
    settings.tube = millimetres(build.ageInYears < 1.0 ? 3.5 : 8.0);
    return settings;
}

/// Over a time at the opening.
struct Extremes {
    double highest_cmH2O = 0.0;
    double fastestOut_lPerS = 0.0;
};

Extremes run(RespiratoryFold& fold, int seconds)
{
    Extremes extremes;
    for (int i = 0; i < seconds * kSecond; ++i) {
        fold.step();
        extremes.highest_cmH2O = std::max(extremes.highest_cmH2O, inCmH2O(fold.moment().opening));
        extremes.fastestOut_lPerS =
            std::max(extremes.fastestOut_lPerS, -inLitresPerSecond(fold.moment().airwayFlow));
    }
    return extremes;
}

} // namespace

/// What a cough does in lungs and ventilator.
class TestCough : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void comesInBursts();
    void raisesThePressureOfTheVentilator();
    void blowsGasOutOfWhoBreathesAlone();
    void leavesNothingBehind();
    void goesOnFromACheckpoint();
    void endsWithinTheLungsOfANewborn();
};

void TestCough::comesInBursts()
{
    constexpr double kRounding = 1e-12;
    VERIFY_WITHIN(coughShare(0.0), 0.0, kRounding);
    VERIFY_WITHIN(coughShare(0.5 * kCoughBurst), 1.0, kRounding);
    VERIFY_WITHIN(coughShare(kCoughBurst / 6.0), 0.5, kRounding); // sin 30 degrees
    QCOMPARE(coughShare(0.5 * (kCoughBurst + kCoughEvery)), 0.0);
    constexpr double kOfHours = 1e-9;
    VERIFY_WITHIN(coughShare(9000.0 * kCoughEvery + 0.5 * kCoughBurst), 1.0, kOfHours);
}

void TestCough::raisesThePressureOfTheVentilator()
{
    RespiratorySettings settings = ventilated(kAdult);
    RespiratoryFold fold{settings};
    run(fold, 20);
    const Extremes before = run(fold, 20);
    settings.cough = 0.5;
    fold.set(settings);
    const Extremes coughing = run(fold, 20);
    QVERIFY2(coughing.highest_cmH2O > before.highest_cmH2O + 5.0,
             qPrintable(QString::number(coughing.highest_cmH2O)));
    QVERIFY(coughing.highest_cmH2O <= inCmH2O(settings.ventilator.pressureLimit) + 1e-6);
    QVERIFY(fold.lastBreath().peak > cmH2O(before.highest_cmH2O));
    QVERIFY(coughing.fastestOut_lPerS > 1.2 * before.fastestOut_lPerS);
}

void TestCough::blowsGasOutOfWhoBreathesAlone()
{
    RespiratorySettings settings = quiet(kAdult);
    RespiratoryFold fold{settings};
    const Extremes before = run(fold, 20);
    settings.cough = 1.0;
    fold.set(settings);
    const Extremes coughing = run(fold, 20);
    QVERIFY2(coughing.fastestOut_lPerS > 2.0 * before.fastestOut_lPerS,
             qPrintable(QString::number(coughing.fastestOut_lPerS)));
    settings.cough = 0.25;
    fold.set(settings);
    run(fold, 5);
    QVERIFY(run(fold, 20).fastestOut_lPerS < coughing.fastestOut_lPerS);
}

/// Another patient never coughed.
void TestCough::leavesNothingBehind()
{
    constexpr double kVolume_ml = 0.5;
    constexpr double kPressure_cmH2O = 0.05;
    RespiratorySettings settings = ventilated(kAdult);
    RespiratoryFold never{settings};
    RespiratoryFold once{settings};
    run(never, 80);
    run(once, 10);
    settings.cough = 1.0;
    once.set(settings);
    run(once, 10);
    settings.cough = 0.0;
    once.set(settings);
    run(once, 60);
    QCOMPARE(once.muscle().si, 0.0);
    VERIFY_WITHIN(inMillilitres(once.lastBreath().tidalVolume),
                  inMillilitres(never.lastBreath().tidalVolume), kVolume_ml);
    VERIFY_WITHIN(inCmH2O(once.lastBreath().peak), inCmH2O(never.lastBreath().peak),
                  kPressure_cmH2O);
}

void TestCough::goesOnFromACheckpoint()
{
    RespiratorySettings settings = ventilated(kAdult);
    settings.cough = 0.6;
    RespiratoryFold fold{settings};
    for (int i = 0; i < 10 * kSecond || fold.muscle().si > -1000.0; ++i)
        fold.step();
    RespiratoryFold late{settings, fold.state()};
    for (int i = 0; i < 5 * kSecond; ++i) {
        fold.step();
        late.step();
    }
    QVERIFY(late.state() == fold.state());
}

void TestCough::endsWithinTheLungsOfANewborn()
{
    RespiratorySettings settings = ventilated(kNewborn);
    settings.cough = 1.0;
    RespiratoryFold fold{settings};
    for (int i = 0; i < 60 * kSecond; ++i) {
        fold.step();
        for (std::size_t lung = 0; lung < 2; ++lung) {
            const PressureVolumeCurve& curve = fold.system().lungs[lung].curve;
            const Volume gas = fold.content()[lung].gas;
            QVERIFY(gas > curve.floor && gas < curve.floor + curve.span);
        }
    }
}

CARINA_TEST(TestCough)

} // namespace carina::cough_test

#include "tst_cough.moc"
