#include "engine/lungs/mechanics/lung_condition.h"

#include "engine/lungs/mechanics/lung_dynamics.h"
#include "tests/engine/lungs/mechanics/afflicted_lungs.h"
#include "tests/engine/lungs/mechanics/within.h"
#include "tests/support/test_class.h"

#include <array>

namespace carina::lung_condition_test
{

using namespace carina::test;

namespace
{

double lungCompliance(const LungMechanics& lung, Volume at)
{
    return inLitresPerCmH2O(lung.curve.complianceAt(at));
}

double bronchialResistance(const RespiratorySystem& system)
{
    return inCmH2OSecondsPerLitre(
        {1.0 / (system.lungs[0].bronchi.si + system.lungs[1].bronchi.si)});
}

Volume restOf(const RespiratorySystem& system)
{
    const ChestContent content = restingContent(system);
    return content[0].gas + content[1].gas;
}

} // namespace

class TestLungCondition : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isHealthyAtNoSeverity();
    void stiffensArdsByTheTable_data();
    void stiffensArdsByTheTable();
    void shrinksTheLungsOfArds();
    void narrowsCopdByTheTable_data();
    void narrowsCopdByTheTable();
    void hyperinflatesCopd();
    void narrowsTheAirwayOfAsthmaFiveToFifteenTimes();
    void narrowsTheTrachea();
    void stiffensTheChest();
    void compressesTheBronchiOfCopd();
    void tiresTheMuscles();
    void changesTheTimesOfBreathingByTheTable_data();
    void changesTheTimesOfBreathingByTheTable();
    void closesAirwaysAboveTheRestingVolume();
};

void TestLungCondition::isHealthyAtNoSeverity()
{
    for (const ConditionKind kind : kConditionKinds) {
        const auto side =
            kind == ConditionKind::MainstemIntubation ? ConditionSide::Right : ConditionSide::Both;
        const RespiratorySystem system = with(kind, 0.0, side);
        const Volume rest = restOf(system);
        VERIFY_WITHIN(inLitres(rest), 2.31, 1e-6);
        VERIFY_WITHIN(bronchialResistance(system), 0.45, 1e-9);
        VERIFY_WITHIN(lungCompliance(system.lungs[1], system.lungs[1].wallVolume), 0.2 * 0.475,
                      1e-9);
        QCOMPARE(system.upperTurbulent, 0.0);
        QCOMPARE(system.effort, 1.0);
    }
    QVERIFY(with(ConditionKind::Normal, 1.0) == healthy());
}

void TestLungCondition::stiffensArdsByTheTable_data()
{
    QTest::addColumn<double>("severity");
    QTest::addColumn<double>("compliance"); // both lungs, of 0.2
    QTest::addColumn<double>("deadSpace_l");
    QTest::newRow("mild") << 0.3 << 0.14 << 0.0;
    QTest::newRow("moderate") << 0.6 << 0.10 << 0.03;
    QTest::newRow("severe") << 0.9 << 0.08 << 0.15;
    QTest::newRow("between") << 0.45 << 0.12 << 0.015;
    QTest::newRow("worst") << 1.0 << 0.2 * (0.4 - 0.1 / 3.0) << 0.19;
}

void TestLungCondition::stiffensArdsByTheTable()
{
    QFETCH(const double, severity);
    QFETCH(const double, compliance);
    QFETCH(const double, deadSpace_l);
    const RespiratorySystem system = with(ConditionKind::Ards, severity);
    const ChestContent rest = restingContent(system);
    double sum = 0.0;
    double dead_l = 0.0;
    for (std::size_t i = 0; i < 2; ++i) {
        sum += lungCompliance(system.lungs[i], rest[i].gas);
        dead_l += inLitres(system.lungs[i].alveolarDeadSpace);
    }
    VERIFY_WITHIN(sum, compliance, 1e-6);
    VERIFY_WITHIN(dead_l, deadSpace_l, 1e-9);
    VERIFY_WITHIN(bronchialResistance(system), 0.45, 1e-9);
}

void TestLungCondition::shrinksTheLungsOfArds()
{
    Volume rest = restOf(healthy());
    for (const double severity : kSeverities) {
        const RespiratorySystem system = with(ConditionKind::Ards, severity);
        QVERIFY(restOf(system) < rest);
        rest = restOf(system);
        VERIFY_WITHIN(inCmH2O(system.lungs[0].limbSpread), 4.0 * (1.0 + severity), 1e-9);
        QVERIFY(system.lungs[0].wall == healthy().lungs[0].wall);
    }
}

void TestLungCondition::narrowsCopdByTheTable_data()
{
    QTest::addColumn<double>("severity");
    QTest::addColumn<double>("resistance");
    QTest::addColumn<double>("compliance");
    QTest::addColumn<double>("deadSpace_l");
    QTest::newRow("mild") << 0.3 << 0.85 << 0.2 << 0.3;
    QTest::newRow("moderate") << 0.6 << 1.7 << 0.22 << 0.6;
    QTest::newRow("severe") << 0.9 << 2.4 << 0.28 << 0.9;
}

void TestLungCondition::narrowsCopdByTheTable()
{
    QFETCH(const double, severity);
    QFETCH(const double, resistance);
    QFETCH(const double, compliance);
    QFETCH(const double, deadSpace_l);
    const RespiratorySystem system = with(ConditionKind::Copd, severity);
    VERIFY_WITHIN(bronchialResistance(system), resistance, 1e-9);
    double sum = 0.0;
    double dead_l = 0.0;
    for (const LungMechanics& lung : system.lungs) {
        sum += lungCompliance(lung, lung.wallVolume);
        dead_l += inLitres(lung.alveolarDeadSpace);
    }
    VERIFY_WITHIN(sum, compliance, 1e-9);
    VERIFY_WITHIN(dead_l, deadSpace_l, 1e-9);
}

/// Severe: resting volume 177, capacity 140 %, and less recoil.
void TestLungCondition::hyperinflatesCopd()
{
    const RespiratorySystem system = with(ConditionKind::Copd, 0.9);
    VERIFY_WITHIN(inLitres(restOf(system)), 1.77 * 2.31, 1e-6);
    Volume capacity;
    for (const LungMechanics& lung : system.lungs)
        capacity = capacity + lung.curve.floor + lung.curve.span;
    VERIFY_WITHIN(inLitres(capacity), 1.40 * 6.16, 1e-9);
    VERIFY_WITHIN(inCmH2O(system.lungs[0].wallRecoil), 2.75, 1e-9);
    VERIFY_WITHIN(system.lungs[0].curve.floor / healthy().lungs[0].curve.floor, 2.42, 1e-9);
    for (const double third : {1.0 / 3.0, 2.0 / 3.0}) { // on straight lines from health
        const RespiratorySystem milder = with(ConditionKind::Copd, 0.9 * third);
        VERIFY_WITHIN(inLitres(restOf(milder)), (1.0 + 0.77 * third) * 2.31, 1e-6);
        const LungMechanics lung = milder.lungs[0];
        const LungMechanics well = healthy().lungs[0];
        VERIFY_WITHIN(lung.curve.floor / well.curve.floor, 1.0 + 1.42 * third, 1e-9);
        VERIFY_WITHIN((lung.curve.floor + lung.curve.span) / (well.curve.floor + well.curve.span),
                      1.0 + 0.40 * third, 1e-9);
    }
}

/// Of 1.575 cmH2O s/L above and below the carina.
void TestLungCondition::narrowsTheAirwayOfAsthmaFiveToFifteenTimes()
{
    const auto factorAt = [](double severity) {
        return (1.125 + bronchialResistance(with(ConditionKind::Asthma, severity))) / 1.575;
    };
    VERIFY_WITHIN(factorAt(2.0 / 7.0), 5.0, 1e-9);
    VERIFY_WITHIN(factorAt(1.0), 15.0, 1e-9);
    QVERIFY(with(ConditionKind::Asthma, 1.0).lungs[0].curve == healthy().lungs[0].curve);
}

/// Borda and Carnot: a jet through a share o of 2 cm2 loses rho/2 (Q/A (1/o - 1))^2. At 1 L/s and a
/// tenth open that is 1215 Pa.
void TestLungCondition::narrowsTheTrachea()
{
    const RespiratorySystem system = with(ConditionKind::Obstruction, 0.9);
    VERIFY_WITHIN(system.upperTurbulent * 1e-6, 1215.0, 1e-6);
    QVERIFY(system.lungs == healthy().lungs);
    VERIFY_WITHIN(with(ConditionKind::Obstruction, 0.995).lungs[1].bronchi.si
                      / healthy().lungs[1].bronchi.si,
                  0.5, 1e-12);
    QCOMPARE(with(ConditionKind::Obstruction, 1.0).lungs[0].bronchi.si, 0.0);
    VERIFY_WITHIN(with(ConditionKind::Obstruction, 1.0).upperTurbulent * 1e-6,
                  1215.0 / 81.0 * 99.0 * 99.0, 1e-6);
}

void TestLungCondition::stiffensTheChest()
{
    const RespiratorySystem system = with(ConditionKind::StiffChest, 1.0);
    for (std::size_t i = 0; i < 2; ++i) {
        VERIFY_WITHIN(system.lungs[i].wall.si / healthy().lungs[i].wall.si, 0.2, 1e-12);
        QVERIFY(system.lungs[i].curve == healthy().lungs[i].curve);
    }
    VERIFY_WITHIN(inLitres(restOf(system)), 2.31, 1e-6);
}

/// To 24.4 cmH2O s/L of the whole airway while gas leaves, when it is severe.
void TestLungCondition::compressesTheBronchiOfCopd()
{
    const RespiratorySystem system = with(ConditionKind::Copd, 0.9);
    VERIFY_WITHIN(1.125 + bronchialResistance(system) * system.lungs[0].compression, 24.4, 0.01);
    double before = 1.0;
    for (const double severity : kSeverities) {
        const double now = with(ConditionKind::Copd, severity).lungs[1].compression;
        QVERIFY(now > before);
        before = now;
    }
    QCOMPARE(with(ConditionKind::Ards, 1.0).lungs[0].compression, 1.0);
}

/// So that a share of the tidal volume is left that the table says: quasi-statically, in series
/// with a wall as compliant as a healthy lung.
void TestLungCondition::tiresTheMuscles()
{
    const double volumeLeft = with(ConditionKind::Ards, 0.9).effort * 2.0 / (1.0 + 1.0 / 0.4);
    VERIFY_WITHIN(volumeLeft, 0.28, 1e-9);
    // 1.7 times 6.8, of which the closing volume of 1.02 times the resting one leaves 0.97 open at
    // rest, and 0.985 in the mean, and 1.125 cmH2O s/L by 0.1048 L/cmH2O.
    const double floor = 0.25 * (1.0 + 2.84 / 3.0) / (1.0 + 1.54 / 3.0);
    const double open = 0.5 * (1.0 + (1.0 - floor) / (1.02 - floor));
    const double tau = (1.7 * 6.8 / open + 1.125) / (1.0 / 0.22 + 1.0 / 0.2);
    const double stays = std::exp(-2.2 / tau);
    VERIFY_WITHIN(with(ConditionKind::Copd, 0.6).effort * (1.0 - stays) * 2.0 / (1.0 + 1.0 / 1.1),
                  0.76, 1e-5);
    VERIFY_WITHIN(with(ConditionKind::Ards, 0.9, ConditionSide::Left).effort,
                  0.5 * (1.0 + with(ConditionKind::Ards, 0.9).effort), 1e-12);
    QCOMPARE(with(ConditionKind::Asthma, 0.9).effort, 1.0);
}

void TestLungCondition::changesTheTimesOfBreathingByTheTable_data()
{
    QTest::addColumn<ConditionKind>("kind");
    QTest::addColumn<double>("severity");
    QTest::addColumn<double>("inspiration"); // to expiration; 0.5 in health
    QTest::newRow("mild ARDS") << ConditionKind::Ards << 0.3 << 0.7;
    QTest::newRow("moderate ARDS") << ConditionKind::Ards << 0.6 << 1.1;
    QTest::newRow("severe ARDS") << ConditionKind::Ards << 0.9 << 1.5;
    QTest::newRow("mild COPD") << ConditionKind::Copd << 0.3 << 0.35;
    QTest::newRow("moderate COPD") << ConditionKind::Copd << 0.6 << 0.22;
    QTest::newRow("severe COPD") << ConditionKind::Copd << 0.9 << 0.12;
    QTest::newRow("asthma") << ConditionKind::Asthma << 0.9 << 0.5;
}

void TestLungCondition::changesTheTimesOfBreathingByTheTable()
{
    QFETCH(const ConditionKind, kind);
    QFETCH(const double, severity);
    QFETCH(const double, inspiration);
    VERIFY_WITHIN(0.5 * with(kind, severity).inspiratoryRatio, inspiration, 1e-9);
    const double half = with(kind, severity, ConditionSide::Left).inspiratoryRatio;
    VERIFY_WITHIN(half, 0.5 * (1.0 + inspiration / 0.5), 1e-9);
}

/// The closing volume exceeds what is left at rest, so that quiet breaths end among airways that
/// close.
void TestLungCondition::closesAirwaysAboveTheRestingVolume()
{
    for (const ConditionKind kind : {ConditionKind::Asthma, ConditionKind::Copd}) {
        const LungMechanics lung = with(kind, 0.9).lungs[0];
        QVERIFY(lung.closing > lung.wallVolume);
        QVERIFY(with(kind, 0.3).lungs[0].closing < lung.closing);
    }
    QCOMPARE(healthy().lungs[0].closing.si, 0.0);
    QCOMPARE(with(ConditionKind::Ards, 0.9).lungs[0].closing.si, 0.0);
}

CARINA_TEST(TestLungCondition)

} // namespace carina::lung_condition_test

#include "tst_lung_condition.moc"
