#include "engine/lungs/mechanics/ventilatory_drive.h"

#include "tests/engine/lungs/mechanics/afflicted_folds.h"
#include "tests/engine/lungs/mechanics/within.h"
#include "tests/support/test_class.h"

#include <cmath>

namespace carina::ventilatory_drive_test
{

using namespace carina::test;

namespace
{

constexpr VolumeFlow kQuiet = litresPerSecond(0.1);

double litresPerMin(VolumeFlow flow) { return 60.0 * inLitresPerSecond(flow); }

} // namespace

/// Figures of textbooks and papers, as ventilatory_drive.h names them.
class TestVentilatoryDrive : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void gathersCarbonDioxideInApnoea();
    void settlesWhereProductionLeaves();
    void raisesEffortAndRateWithCarbonDioxide();
    void usesHalfOfTheStrengthAtMost();
    void tiresAboveTheCriticalIndexOnly();
    void recoversWithNormalCarbonDioxideOnly();
    void leavesQuietBreathingAlone();
    void severeArdsBreathesHarderFirstAndTiresLater();
    void hasTheTimesOfTheDiseaseInOwnBreathsOnly();
    void restsOnAVentilator();
    void strugglesWhereNoSetBreathGetsBeyondTheDeadSpace();
};

/// 4 mmHg a minute from 40.
void TestVentilatoryDrive::gathersCarbonDioxideInApnoea()
{
    VERIFY_WITHIN(40.0 * carbonDioxideAfter(60.0, 1.0, kQuiet, {}), 44.0, 1e-9);
    QCOMPARE(carbonDioxideAfter(1e9, 1.0, kQuiet, {}), kMostCarbonDioxide);
}

/// The tension is inversely proportional to alveolar ventilation.
void TestVentilatoryDrive::settlesWhereProductionLeaves()
{
    for (const double share : {0.5, 1.0, 2.0}) {
        double tension = 1.3;
        for (int breath = 0; breath < 5000; ++breath)
            tension = carbonDioxideAfter(4.0, tension, kQuiet, share * kQuiet);
        VERIFY_WITHIN(tension, 1.0 / share, 1e-6);
    }
}

void TestVentilatoryDrive::raisesEffortAndRateWithCarbonDioxide()
{
    const Pressure quiet = cmH2O(6.0);
    QCOMPARE(drivenEffort({1.0, 0.0}, quiet, 1.0, 1.0), 1.0);
    QCOMPARE(drivenRate({1.0, 0.0}), 1.0);
    // 10 mmHg above the threshold: 0.3 cmH2O/mmHg from 1 cmH2O are four times.
    VERIFY_WITHIN(drivenEffort({1.27, 0.0}, quiet, 1.0, 1.0), 4.0, 1e-9);
    VERIFY_WITHIN(drivenRate({1.27, 0.0}), 1.75, 1e-9);
    QCOMPARE(drivenRate({3.0, 0.0}), kMostRate);
}

void TestVentilatoryDrive::usesHalfOfTheStrengthAtMost()
{
    VERIFY_WITHIN(drivenEffort({4.0, 0.0}, cmH2O(5.0), 1.0, 1.0), 10.0, 1e-9);
    VERIFY_WITHIN(drivenEffort({4.0, 0.0}, cmH2O(5.0), 0.4, 1.0), 4.0, 1e-9);
    VERIFY_WITHIN(drivenEffort({4.0, 1.0}, cmH2O(5.0), 0.4, 0.5), 0.5, 1e-9);
    VERIFY_WITHIN(drivenEffort({4.0, 0.5}, cmH2O(5.0), 0.4, 0.5), 2.25, 1e-9);
}

/// 0.1 min / 0.2^3.6 = 33 min; at 0.15 and below a breath can be repeated for ever.
void TestVentilatoryDrive::tiresAboveTheCriticalIndexOnly()
{
    QCOMPARE(tirednessAfter(4.0, {1.2, 0.0}, cmH2O(14.9), 1.0), 0.0);
    const double inAMinute = tirednessAfter(60.0, {1.2, 0.0}, cmH2O(20.0), 1.0);
    VERIFY_WITHIN(1.0 / inAMinute, 33.0, 0.5);
    QVERIFY(tirednessAfter(60.0, {1.2, 0.0}, cmH2O(20.0), 0.5) > inAMinute);
    QVERIFY(tirednessAfter(60.0, {1.2, 0.5}, cmH2O(20.0), 1.0) > 0.5 + inAMinute);
    QCOMPARE(tirednessAfter(1e9, {1.2, 0.0}, cmH2O(20.0), 1.0), 1.0);
}

void TestVentilatoryDrive::recoversWithNormalCarbonDioxideOnly()
{
    QCOMPARE(tirednessAfter(60.0, {1.2, 0.8}, {}, 1.0), 0.8);
    VERIFY_WITHIN(tirednessAfter(450.0, {1.0, 0.8}, {}, 1.0), 0.3, 1e-9);
    QCOMPARE(tirednessAfter(1e4, {1.0, 0.8}, {}, 1.0), 0.0);
}

void TestVentilatoryDrive::leavesQuietBreathingAlone()
{
    const RespiratoryFold fold =
        after(10 * kMinute, settingsWith(VentilationMode::Spontaneous, {}));
    VERIFY_WITHIN(fold.state().drive.carbonDioxide, 1.0, kDriveThreshold);
    QCOMPARE(fold.state().drive.tiredness, 0.0);
    VERIFY_WITHIN(inPerMinute(fold.lastBreath().rate), 16.0, 0.01);
}

/// Alveolar ventilation of 5.9 L/min in health.
void TestVentilatoryDrive::severeArdsBreathesHarderFirstAndTiresLater()
{
    const RespiratorySettings ill =
        settingsWith(VentilationMode::Spontaneous, condition(ConditionKind::Ards, 0.9));
    RespiratoryFold fold{ill};
    const auto breathe = [&fold](int minutes) {
        for (int i = 0; i < minutes * kMinute; ++i)
            fold.step();
        return fold.lastBreath();
    };
    const BreathFigures soon = breathe(1);
    const BreathFigures later = breathe(4);
    const Pressure effort = fold.state().effort;
    QVERIFY(litresPerMin(soon.alveolarVentilation) > 1.0);
    QVERIFY(litresPerMin(later.alveolarVentilation) > 4.0);
    QVERIFY(later.rate > soon.rate && inPerMinute(later.rate) > 17.0);
    QVERIFY(fold.state().drive.tiredness < 0.3);
    const BreathFigures tired = breathe(55);
    QVERIFY(fold.state().drive.tiredness > 0.7);
    QVERIFY(fold.state().effort < 0.6 * effort);
    QVERIFY(litresPerMin(tired.alveolarVentilation) < 2.0);
    QVERIFY(tired.rate > later.rate); // rapid and shallow
    QVERIFY(tired.tidalVolume < 0.6 * later.tidalVolume);
}

void TestVentilatoryDrive::hasTheTimesOfTheDiseaseInOwnBreathsOnly()
{
    const LungCondition severe = condition(ConditionKind::Copd, 0.9);
    const auto ratio = [&](VentilationMode mode) {
        const double fraction =
            after(kMinute, settingsWith(mode, severe)).state().breath.inspiratoryFraction;
        return fraction / (1.0 - fraction);
    };
    // Of 0.6, which is the I:E of 16 breaths a minute.
    VERIFY_WITHIN(ratio(VentilationMode::Spontaneous), 0.6 * 0.12 / 0.5, 1e-6);
    VERIFY_WITHIN(ratio(VentilationMode::VolumeControl), 0.6, 1e-12);
}

/// A ventilator brings the carbon dioxide back, and the muscles recover.
void TestVentilatoryDrive::restsOnAVentilator()
{
    RespiratorySettings settings =
        settingsWith(VentilationMode::VolumeControl, condition(ConditionKind::Ards, 0.9));
    RespiratoryState tired = RespiratoryFold{settings}.state();
    tired.drive = {1.8, 0.9};
    RespiratoryFold fold{settings, tired};
    for (int i = 0; i < 60 * kMinute; ++i)
        fold.step();
    QVERIFY(fold.state().drive.carbonDioxide < 1.1);
    QCOMPARE(fold.state().drive.tiredness, 0.0);
}

/// At first nothing is ventilated, as in apnoea; then breaths grow until some air arrives.
void TestVentilatoryDrive::strugglesWhereNoSetBreathGetsBeyondTheDeadSpace()
{
    RespiratorySettings shallow = settingsWith(VentilationMode::Spontaneous, {});
    shallow.pattern.tidalVolume = millilitres(100.0);
    RespiratoryFold fold = after(kMinute / 6, shallow);
    QCOMPARE(fold.lastBreath().alveolarVentilation.si, 0.0);
    VERIFY_WITHIN(fold.state().drive.carbonDioxide, 1.0 + 10.0 / kStoreTime, 0.01);
    const Pressure quiet = fold.state().effort;
    for (int i = 0; i < 10 * kMinute; ++i)
        fold.step();
    QVERIFY(fold.state().drive.carbonDioxide > 1.1);
    QVERIFY(fold.state().effort > 2.0 * quiet);
    QVERIFY(fold.lastBreath().rate > 1.2 * shallow.pattern.rate);
    QVERIFY(fold.lastBreath().tidalVolume > healthySystem({}).anatomicalDeadSpace);
    QVERIFY(litresPerMin(fold.lastBreath().alveolarVentilation) > 2.0);
}

CARINA_TEST(TestVentilatoryDrive)

} // namespace carina::ventilatory_drive_test

#include "tst_ventilatory_drive.moc"
