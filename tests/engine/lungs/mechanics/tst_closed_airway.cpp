#include "tests/engine/lungs/mechanics/afflicted_folds.h"
#include "tests/engine/lungs/mechanics/within.h"
#include "tests/support/test_class.h"

namespace carina::closed_airway_test
{

using namespace carina::test;

/// Airways that are all but closed, and wholly.
class TestClosedAirway : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void letsNothingThroughAClosedTrachea_data();
    void letsNothingThroughAClosedTrachea();
    void staysFiniteInEveryCondition();
};

void TestClosedAirway::letsNothingThroughAClosedTrachea_data()
{
    QTest::addColumn<bool>("comesIn");
    QTest::newRow("from the start") << false;
    QTest::newRow("as it comes in") << true;
}

/// Volume control meets its limit in every inspiration and moves no gas; a patient's own effort
/// neither.
void TestClosedAirway::letsNothingThroughAClosedTrachea()
{
    QFETCH(const bool, comesIn);
    const LungCondition closed{ConditionKind::Obstruction, 1.0, ConditionSide::Both};
    for (const VentilationMode mode :
         {VentilationMode::VolumeControl, VentilationMode::Spontaneous}) {
        RespiratorySettings settings = settingsWith(mode, comesIn ? LungCondition{} : closed);
        settings.ventilator.pressureLimit = cmH2O(40.0);
        RespiratoryFold fold{settings};
        settings.conditions = {closed};
        fold.set(settings);
        for (int i = 0; i < 2 * kMinute; ++i)
            fold.step();
        const Volume before = fold.content()[0].gas;
        for (int i = 0; i < kMinute / 6; ++i)
            fold.step();
        QCOMPARE(fold.content()[0].gas, before);
        QCOMPARE(fold.lastBreath().tidalVolume.si, 0.0);
        if (mode == VentilationMode::Spontaneous)
            continue;
        VERIFY_WITHIN(inCmH2O(fold.lastBreath().peak), 40.0, 1e-9);
        QCOMPARE(fold.lastBreath().autoPeep.si, 0.0);
    }
}

/// And so do their ends, one side or both, whoever breathes.
void TestClosedAirway::staysFiniteInEveryCondition()
{
    for (const ConditionKind kind : kConditionKinds) {
        for (const auto side : {ConditionSide::Both, ConditionSide::Left}) {
            if (kind == ConditionKind::MainstemIntubation && side == ConditionSide::Both)
                continue;
            for (const double severity : {0.0, 0.5, 0.99, 0.999, 1.0}) {
                const auto mode = VentilationMode(static_cast<int>(1e3 * severity) % 3);
                const RespiratoryFold fold =
                    after(2500, settingsWith(mode, {kind, severity, side}));
                const BreathFigures& breath = fold.lastBreath();
                QVERIFY(std::isfinite(breath.tidalVolume.si) && std::isfinite(breath.peak.si));
                QVERIFY(std::isfinite(breath.plateau.si) && std::isfinite(breath.autoPeep.si));
                QVERIFY(std::isfinite(fold.content()[0].gas.si + fold.content()[1].gas.si));
                QVERIFY(std::isfinite(fold.moment().airwayFlow.si));
            }
        }
    }
}

CARINA_TEST(TestClosedAirway)

} // namespace carina::closed_airway_test

#include "tst_closed_airway.moc"
