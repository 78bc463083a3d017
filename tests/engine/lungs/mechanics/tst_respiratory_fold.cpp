#include "engine/lungs/mechanics/respiratory_fold.h"

#include "tests/engine/lungs/mechanics/within.h"
#include "tests/support/test_class.h"

#include <algorithm>

namespace carina::respiratory_fold_test
{

namespace
{

constexpr int kSecond = 500; // steps

RespiratorySettings quiet(const PatientBuild& build = {})
{
    RespiratorySettings settings;
    settings.build = build;
    settings.pattern = restingPattern(build);
    return settings;
}

RespiratorySettings ventilated(const PatientBuild& build = {})
{
    RespiratorySettings settings = quiet(build);
    settings.ventilator.mode = VentilationMode::VolumeControl;
    settings.tube = millimetres(8.0);
    return settings;
}

PatientBuild twelveYears() { return {metres(1.5), 40.0, 12.0, Sex::Female}; }

void run(RespiratoryFold& fold, int steps)
{
    for (int i = 0; i < steps; ++i)
        fold.step();
}

double gas_ml(const RespiratoryFold& fold)
{
    return inMillilitres(fold.content()[0].gas + fold.content()[1].gas);
}

} // namespace

class TestRespiratoryFold : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void breathesTheVolumeThatWasSet_data();
    void breathesTheVolumeThatWasSet();
    void breathesAtTheRateThatWasSet();
    void keepsAlveolarPressureWithinThePublishedSwing();
    void sumsUpABreathOfAVentilator();
    void countsBothDeadSpaces();
    void takesATidalVolumeWithTheNextBreath();
    void comesToAConditionWithoutAJump();
    void followsTheBreathsOfTheManikin();
    void isTriggeredByThePatientsOwnEffort();
    void gainsWhatFlowsIn();
    void relaxesWhenAVentilatorTakesOver();
    void breathesNoDeeperThanThePatientCan();
};

void TestRespiratoryFold::breathesTheVolumeThatWasSet_data()
{
    QTest::addColumn<bool>("isChild");
    QTest::addColumn<double>("tidalVolume_ml");
    QTest::addColumn<double>("rate_perMin");
    QTest::newRow("adult, quiet") << false << 539.0 << 16.0;
    QTest::newRow("adult, deep") << false << 1200.0 << 12.0;
    QTest::newRow("adult, as deep as can be") << false << 1925.0 << 8.0;
    QTest::newRow("adult, fast") << false << 350.0 << 40.0;
    QTest::newRow("12 years, quiet") << true << 280.0 << 19.0;
    QTest::newRow("12 years, shallow") << true << 120.0 << 19.0;
    QTest::newRow("12 years, deep") << true << 350.0 << 19.0;
    QTest::newRow("12 years, deep and faster") << true << 350.0 << 24.0;
    QTest::newRow("12 years, fast") << true << 200.0 << 60.0;
}

/// In every position.
void TestRespiratoryFold::breathesTheVolumeThatWasSet()
{
    constexpr double kWithin = 0.01;
    QFETCH(const bool, isChild);
    QFETCH(const double, tidalVolume_ml);
    QFETCH(const double, rate_perMin);
    RespiratorySettings settings = quiet(isChild ? twelveYears() : PatientBuild{});
    settings.pattern.tidalVolume = millilitres(tidalVolume_ml);
    settings.pattern.rate = perMinute(rate_perMin);
    for (const BodyPosition position : kBodyPositions) {
        settings.position = position;
        RespiratoryFold fold{settings};
        run(fold, 60 * kSecond);
        const BreathFigures& breath = fold.lastBreath();
        VERIFY_WITHIN(inMillilitres(breath.tidalVolume) / tidalVolume_ml, 1.0, kWithin);
        if (position != BodyPosition::Supine)
            continue;
        VERIFY_WITHIN(breath.tidalVolumeOfLung[0] / breath.tidalVolume, 0.525, 0.002);
        VERIFY_WITHIN(breath.tidalVolumeOfLung[1] / breath.tidalVolume, 0.475, 0.002);
    }
}

void TestRespiratoryFold::breathesAtTheRateThatWasSet()
{
    for (const double rate : {12.0, 40.0}) {
        RespiratorySettings settings = quiet();
        settings.pattern.rate = perMinute(rate);
        RespiratoryFold fold{settings};
        run(fold, 30 * kSecond);
        VERIFY_WITHIN(inPerMinute(fold.lastBreath().rate), rate, 0.1);
        settings.ventilator.mode = VentilationMode::PressureControl;
        fold.set(settings);
        run(fold, 30 * kSecond);
        VERIFY_WITHIN(inPerMinute(fold.lastBreath().rate), rate, 0.1);
    }
}

/// In quiet breathing -1.8 to +1.8 cmH2O in an adult's alveoli (Otis), and flow there and back. A
/// child of 12 breathes half the gas in nine tenths of the time through 3.3 times the resistance.
void TestRespiratoryFold::keepsAlveolarPressureWithinThePublishedSwing()
{
    for (const bool isChild : {false, true}) {
        const double limit = isChild ? 1.8 * 3.3 * 0.52 / 0.9 : 1.8;
        RespiratoryFold fold{quiet(isChild ? twelveYears() : PatientBuild{})};
        double least = 0.0;
        double most = 0.0;
        for (int i = 0; i < 20 * kSecond; ++i) {
            fold.step();
            least = std::min(least, inCmH2O(fold.moment().alveolar[0]));
            most = std::max(most, inCmH2O(fold.moment().alveolar[0]));
        }
        QVERIFY2(least > -limit && least < -0.5, qPrintable(QString::number(least)));
        QVERIFY2(most < limit && most > 0.5, qPrintable(QString::number(most)));
    }
}

void TestRespiratoryFold::sumsUpABreathOfAVentilator()
{
    RespiratoryFold fold{ventilated()};
    run(fold, 60 * kSecond);
    const BreathFigures& breath = fold.lastBreath();
    VERIFY_WITHIN(inMillilitres(breath.tidalVolume), 539.0, 0.01);
    QVERIFY(breath.peak > breath.plateau);
    // At the end of the pause both lungs have what the breath brought: a compliance of 50 to 80
    // ml/cmH2O, as ventilated patients have it.
    const double compliance =
        inMillilitres(breath.tidalVolume) / inCmH2O(breath.plateau - breath.endExpiratory);
    QVERIFY2(compliance > 50.0 && compliance < 80.0, qPrintable(QString::number(compliance)));
    VERIFY_WITHIN(inCmH2O(breath.endExpiratory), 5.0, 0.05);
    VERIFY_WITHIN(inCmH2O(breath.autoPeep), 0.0, 0.05);
}

/// (VT - anatomical) f; of the alveolar dead space its share of all gas is lost besides.
void TestRespiratoryFold::countsBothDeadSpaces()
{
    RespiratoryFold healthy{ventilated()};
    run(healthy, 30 * kSecond);
    const double expected = (0.539 - 0.0011 * 77.0) * 16.0;
    VERIFY_WITHIN(healthy.lastBreath().alveolarVentilation.si * 6e4, expected, 0.01);

    RespiratorySettings ill = ventilated();
    ill.conditions = {{ConditionKind::Copd, 0.9, ConditionSide::Both}};
    RespiratoryFold fold{ill};
    run(fold, 60 * kSecond);
    while (fold.state().tally.steps != 1)
        fold.step();
    const double dead_ml = 900.0 * 25.0 / 30.0; // of the 2.31 L of one awake, relaxed
    VERIFY_WITHIN(fold.lastBreath().alveolarVentilation.si * 6e4,
                  expected * (1.0 - dead_ml / gas_ml(fold)), 0.02);
}

/// The breath under way is not changed.
void TestRespiratoryFold::takesATidalVolumeWithTheNextBreath()
{
    RespiratorySettings settings = quiet(); // breaths of 3.75 s
    RespiratoryFold changed{settings};
    RespiratoryFold kept{settings};
    run(changed, 5 * kSecond);
    run(kept, 5 * kSecond);
    settings.pattern.tidalVolume = millilitres(900.0);
    changed.set(settings);
    run(changed, 2 * kSecond);
    run(kept, 2 * kSecond);
    QVERIFY(changed.content() == kept.content());
    run(changed, 30 * kSecond);
    VERIFY_WITHIN(inMillilitres(changed.lastBreath().tidalVolume), 900.0, 30.0);
}

/// The gas follows the worst change of condition no faster than a hard breath would move it.
void TestRespiratoryFold::comesToAConditionWithoutAJump()
{
    RespiratorySettings settings = quiet();
    RespiratoryFold fold{settings};
    run(fold, 10 * kSecond);
    settings.conditions = {{ConditionKind::Copd, 1.0, ConditionSide::Both}};
    fold.set(settings);
    double before = gas_ml(fold);
    for (int i = 0; i < 20 * kSecond; ++i) {
        fold.step();
        const double now = gas_ml(fold);
        QVERIFY2(std::abs(now - before) < 2.0 * 1000.0 * kRespiratoryStep,
                 qPrintable(QString::number(now - before)));
        before = now;
    }
    QVERIFY(before > 1.5 * 2310.0);
}

void TestRespiratoryFold::followsTheBreathsOfTheManikin()
{
    RespiratoryFold fold{quiet()};
    constexpr int kPeriod = 1250; // steps: 24 per minute
    for (int i = 0; i < 20 * kPeriod; ++i) {
        if (i % kPeriod == 400)
            fold.trigger(0.0);
        fold.step();
    }
    VERIFY_WITHIN(inPerMinute(fold.lastBreath().rate), 24.0, 0.1);
    // 850 steps of the 1250 have gone since a breath began.
    const double breaths = fold.state().clock.breaths;
    VERIFY_WITHIN(breaths - std::floor(breaths), 850.0 / 1250.0, 0.01);
}

/// A patient who breathes 20 times a minute asks a ventilator set to 12 for each of them; one who
/// is not heard gets 12.
void TestRespiratoryFold::isTriggeredByThePatientsOwnEffort()
{
    RespiratorySettings settings = ventilated();
    settings.pattern.rate = perMinute(12.0);
    settings.ventilator.ownRate = perMinute(20.0);
    settings.ventilator.ownEffort = 0.5;
    RespiratoryFold unheard{settings};
    run(unheard, 60 * kSecond);
    VERIFY_WITHIN(inPerMinute(unheard.lastBreath().rate), 12.0, 0.01);
    settings.ventilator.trigger = litresPerSecond(0.033);
    RespiratoryFold heard{settings};
    run(heard, 60 * kSecond);
    VERIFY_WITHIN(inPerMinute(heard.lastBreath().rate), 20.0, 0.5);
}

/// Flow at the opening summed over a minute of breaths is the gas gained, to what a step of the
/// trapezoidal rule leaves at each jump of a ventilator's flow.
void TestRespiratoryFold::gainsWhatFlowsIn()
{
    RespiratoryFold fold{quiet()};
    run(fold, kSecond);
    const double before = gas_ml(fold);
    double sum_ml = 0.0;
    for (int i = 0; i < 60 * kSecond; ++i) {
        const double first = fold.moment().airwayFlow.si;
        fold.step();
        sum_ml += 1e6 * 0.5 * (first + fold.moment().airwayFlow.si) * kRespiratoryStep;
        VERIFY_WITHIN(gas_ml(fold) - before, sum_ml, 0.01);
    }
}

/// A ventilator's breath that puts an end to the patient's own in mid-effort: the muscle lets go in
/// about a tenth of a second, not in one step.
void TestRespiratoryFold::relaxesWhenAVentilatorTakesOver()
{
    RespiratorySettings settings = ventilated();
    settings.pattern.rate = perMinute(12.0); // 2500 steps
    settings.ventilator.ownRate = perMinute(17.0);
    settings.ventilator.ownEffort = 1.0;
    RespiratoryFold fold{settings};
    while (fold.state().ventilator.sinceBreath < 2500 || inCmH2O(fold.muscle()) < 5.0) {
        fold.step();
        QVERIFY(fold.state().steps < 60 * kSecond);
    }
    settings.ventilator.ownEffort = 0.0;
    fold.set(settings);
    double before = inCmH2O(fold.muscle());
    const double steps = before / 0.2;
    int taken = 0;
    while (fold.muscle().si != 0.0) {
        fold.step();
        const double now = inCmH2O(fold.muscle());
        QVERIFY(now <= before && before - now < 0.2001);
        before = now;
        QVERIFY(++taken < 500);
    }
    VERIFY_WITHIN(taken, steps, 1.0);
}

/// A volume that was set for another patient: half of the inspiratory capacity at the most.
void TestRespiratoryFold::breathesNoDeeperThanThePatientCan()
{
    RespiratorySettings settings = ventilated(twelveYears());
    settings.pattern.tidalVolume = litres(2.0);
    settings.ventilator.pressureLimit = cmH2O(100.0);
    RespiratoryFold fold{settings};
    run(fold, 20 * kSecond);
    VERIFY_WITHIN(inMillilitres(fold.lastBreath().tidalVolume), 1000.0, 1.0);
}

CARINA_TEST(TestRespiratoryFold)

} // namespace carina::respiratory_fold_test

#include "tst_respiratory_fold.moc"
