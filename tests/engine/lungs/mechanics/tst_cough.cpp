#include "engine/lungs/mechanics/respiratory_fold.h"
#include "tests/engine/lungs/mechanics/within.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <array>
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
    void staysWithinBoundsInInfants_data();
    void staysWithinBoundsInInfants();
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

void TestCough::staysWithinBoundsInInfants_data()
{
    QTest::addColumn<double>("age_years");
    QTest::addColumn<double>("height_m");
    QTest::addColumn<double>("weight_kg");
    QTest::addColumn<double>("tube_mm");
    for (const double tube_mm : {0.0, 3.5}) {
        const auto row = [tube_mm](const char* name, double age, double height, double weight) {
            const QByteArray tag = QByteArray{name} + (tube_mm > 0.0 ? ", tube" : ", no tube");
            QTest::newRow(tag.constData()) << age << height << weight << tube_mm;
        };
        row("newborn", 0.0, 0.50, 3.3);
        row("5 weeks", 0.1, 0.55, 4.3);
        row("1 year", 1.0, 0.75, 9.2);
    }
}

/// A minute of the hardest coughs, alone and against a ventilator. What presses on the gas are the
/// expiratory muscles and the ventilator, each up to its limit, and the inspiratory muscles in
/// between; a chest that was squeezed springs back with no more than it was squeezed by. A lung
/// holds more than when it is squeezed empty, and less than its capacity. In a step of 2 ms the
/// muscles' pressure rises by 1 cmH2O at most, and the flow adds some in a small lung; what changes
/// more is an integration that swings.
void TestCough::staysWithinBoundsInInfants()
{
    constexpr double kBreath_cmH2O = 15.0;    // of the inspiratory muscles, against the tube, too
    constexpr double kMostInStep_cmH2O = 5.0; // with what the flow of 2 ms brings to a small lung
    constexpr double kFastest_lPerS = 6.0;    // 360 L/min, of the weakest coughs of healthy adults
    QFETCH(const double, age_years);
    QFETCH(const double, height_m);
    QFETCH(const double, weight_kg);
    QFETCH(const double, tube_mm);
    const PatientBuild infant{metres(height_m), weight_kg, age_years, Sex::Female};
    RespiratorySettings settings = quiet(infant);
    settings.tube = millimetres(tube_mm);
    if (tube_mm > 0.0)
        settings.ventilator.mode = VentilationMode::VolumeControl;
    settings.cough = 1.0;
    RespiratoryFold fold{settings};
    const double cough_cmH2O = inCmH2O(kCoughPressure);
    const double blown_cmH2O = tube_mm > 0.0 ? inCmH2O(settings.ventilator.pressureLimit) : 0.0;
    std::array<double, 2> before{};
    for (int i = 0; i < 60 * kSecond; ++i) {
        fold.step();
        for (std::size_t lung = 0; lung < 2; ++lung) {
            const PressureVolumeCurve& curve = fold.system().lungs[lung].curve;
            const Volume gas = fold.content()[lung].gas;
            QVERIFY(gas > curve.floor && gas < curve.floor + curve.span);
            const double alveolar = inCmH2O(fold.moment().alveolar[lung]);
            const double pleural = inCmH2O(fold.moment().pleural[lung]);
            for (const double pressure : {alveolar, pleural})
                QVERIFY2(pressure > -cough_cmH2O - kBreath_cmH2O
                             && pressure < cough_cmH2O + blown_cmH2O + kBreath_cmH2O,
                         qPrintable(QString::number(pressure)));
            QVERIFY2(i == 0 || std::abs(alveolar - before[lung]) < kMostInStep_cmH2O,
                     qPrintable(QString::number(alveolar - before[lung])));
            before[lung] = alveolar;
        }
        const double flow = inLitresPerSecond(fold.moment().airwayFlow);
        QVERIFY2(std::abs(flow) < kFastest_lPerS, qPrintable(QString::number(flow)));
    }
}

CARINA_TEST(TestCough)

} // namespace carina::cough_test

#include "tst_cough.moc"
