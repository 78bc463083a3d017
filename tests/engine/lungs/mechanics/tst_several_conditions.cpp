#include "tests/engine/lungs/mechanics/afflicted_folds.h"
#include "tests/engine/lungs/mechanics/afflicted_lungs.h"
#include "tests/engine/lungs/mechanics/within.h"
#include "tests/support/test_class.h"

#include <cmath>

namespace carina::several_conditions_test
{

using namespace carina::test;
using enum ConditionKind;
using enum ConditionSide;

namespace
{

LungCondition at(ConditionKind kind, double severity)
{
    return {kind, severity, kind == MainstemIntubation ? Right : Both};
}

RespiratorySettings breathing(VentilationMode mode, const LungConditions& conditions)
{
    RespiratorySettings settings = settingsWith(mode, {});
    settings.conditions = conditions;
    return settings;
}

} // namespace

/// Several diseases at once, each with its side and severity.
class TestSeveralConditions : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void allowsADiseaseOnceOnALung();
    void isTheSameInAnyOrder();
    void isWhatEachAloneMakes();
    void addsTheResistancesUp();
    void closesAShareOfWhatThePleuralGasHasLeft();
    void breathesWithEveryTwo_data();
    void breathesWithEveryTwo();
};

void TestSeveralConditions::allowsADiseaseOnceOnALung()
{
    QVERIFY(canCoexist({}));
    QVERIFY(canCoexist({{Asthma, 0.9, Both}, {SimplePneumothorax, 0.5, Left}}));
    QVERIFY(canCoexist({{Atelectasis, 0.9, Right}, {Atelectasis, 0.5, Left}}));
    QVERIFY(!canCoexist({{Atelectasis, 0.9, Both}, {Atelectasis, 0.5, Left}}));
    QVERIFY(!canCoexist({{Ards, 0.9, Both}, {Ards, 0.5, Both}}));
    QVERIFY(!canCoexist({{Normal, 0.0, Both}}));
    QVERIFY(!canCoexist({{MainstemIntubation, 0.5, Right}, {MainstemIntubation, 0.5, Left}}));
    LungConditions all{{Ards, 0.1, Both},        {Copd, 0.1, Both},        {Asthma, 0.1, Both},
                       {Atelectasis, 0.1, Both}, {Obstruction, 0.1, Both}, {StiffChest, 0.1, Both}};
    QVERIFY(canCoexist(all));
    all.push_back({TensionPneumothorax, 0.1, Left});
    QVERIFY(!canCoexist(all));
}

void TestSeveralConditions::isTheSameInAnyOrder()
{
    const LungCondition copd{Copd, 0.6, Both};
    const LungCondition right{SimplePneumothorax, 0.5, Right};
    const LungCondition left{SimplePneumothorax, 0.3, Left};
    QVERIFY(afflicted(healthy(), LungConditions{copd, right, left})
            == afflicted(healthy(), LungConditions{left, copd, right}));
}

void TestSeveralConditions::isWhatEachAloneMakes()
{
    QVERIFY(afflicted(healthy(), LungConditions{}) == healthy());
    QVERIFY(afflicted(healthy(), LungConditions{at(Copd, 0.7)}) == with(Copd, 0.7));
    // Each on its own lung leaves the other's alone.
    const RespiratorySystem system =
        afflicted(healthy(), LungConditions{{Ards, 0.6, Right}, {Asthma, 0.6, Left}});
    QVERIFY(system.lungs[0] == with(Ards, 0.6, Right).lungs[0]);
    QVERIFY(system.lungs[1] == with(Asthma, 0.6, Left).lungs[1]);
}

/// A trachea half closed and asthma: the one's turbulence, the other's bronchi.
void TestSeveralConditions::addsTheResistancesUp()
{
    const RespiratorySystem system =
        afflicted(healthy(), LungConditions{at(Asthma, 0.6), at(Obstruction, 0.5)});
    QCOMPARE(system.upperTurbulent, with(Obstruction, 0.5).upperTurbulent);
    QCOMPARE(system.lungs[0].bronchi, with(Asthma, 0.6).lungs[0].bronchi);
    const RespiratorySystem both =
        afflicted(healthy(), LungConditions{at(Asthma, 0.6), at(Copd, 0.6)});
    VERIFY_WITHIN(both.lungs[0].compression,
                  with(Asthma, 0.6).lungs[0].compression * with(Copd, 0.6).lungs[0].compression,
                  1e-12);
}

/// Without a mediastinum that gives way, a lung that is closed by a share rests at the open share
/// of its gas above the floor, whether or not there is gas in the pleural space.
void TestSeveralConditions::closesAShareOfWhatThePleuralGasHasLeft()
{
    RespiratorySystem chest = healthy();
    chest.mediastinum = {};
    const auto rest = [&chest](const LungConditions& conditions) {
        return restingContent(afflicted(chest, conditions))[0].gas;
    };
    const Volume floor = chest.lungs[0].curve.floor;
    for (const double severity : {0.0, 0.3, 0.6, 0.9}) {
        const LungCondition gas{SimplePneumothorax, severity, Right};
        const Volume before = rest({gas});
        const Volume after = rest({gas, {Atelectasis, 0.6, Right}});
        VERIFY_WITHIN(inMillilitres(after - floor), 0.46 * inMillilitres(before - floor), 0.01);
    }
}

void TestSeveralConditions::breathesWithEveryTwo_data()
{
    QTest::addColumn<ConditionKind>("first");
    for (const ConditionKind kind : kConditionKinds)
        if (kind != Normal)
            QTest::addRow("%d", int(kind)) << kind;
}

/// At their worst: the gas stays within what a lung can hold, and every figure is finite.
void TestSeveralConditions::breathesWithEveryTwo()
{
    QFETCH(const ConditionKind, first);
    for (const ConditionKind second : kConditionKinds) {
        if (second == Normal || second == first)
            continue;
        for (const VentilationMode mode :
             {VentilationMode::Spontaneous, VentilationMode::VolumeControl}) {
            const RespiratoryFold fold =
                after(kMinute / 3, breathing(mode, {at(first, 1.0), at(second, 1.0)}));
            for (const LungContent& lung : fold.content()) {
                QVERIFY(std::isfinite(lung.gas.si) && lung.gas.si > 0.0);
                QVERIFY(inLitres(lung.gas) < 7.0);
            }
            QVERIFY(std::isfinite(fold.lastBreath().peak.si));
            QVERIFY(std::isfinite(fold.lastBreath().alveolarVentilation.si));
        }
    }
}

CARINA_TEST(TestSeveralConditions)

} // namespace carina::several_conditions_test

#include "tst_several_conditions.moc"
