#include "engine/lungs/mechanics/lung_dynamics.h"

#include "tests/engine/lungs/drawing/chest_samples.h"
#include "tests/engine/lungs/mechanics/within.h"
#include "tests/support/test_class.h"

#include <numbers>

namespace carina::lung_dynamics_test
{

using namespace carina::test;

class TestLungDynamics : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void restsInBalance();
    void fillsAsAResistanceAndACompliance();
    void emptiesExponentially();
    void emptiesLongerThroughCompressedBronchi();
    void sharesGasByCompliance();
    void fillsTheFasterLungFirst();
    void holdsTheCompliancesInSeries();
    void losesPressureToLaminarAndTurbulentFlow();
    void drivesAFlowUpToItsLimit();
    void drivesNothingIntoAClosedAirway();
    void givesAllToTheOpenSide();
    void pullsInWhatTheMusclesPull();
};

void TestLungDynamics::restsInBalance()
{
    const RespiratorySystem healthy = healthySystem({});
    const ChestContent content = restingContent(healthy);
    VERIFY_WITHIN(inLitres(content[0].gas), 0.525 * 2.31, kVolumeTolerance_l);
    VERIFY_WITHIN(inLitres(content[1].gas), 0.475 * 2.31, kVolumeTolerance_l);
    const ChestMoment moment = chestMoment(healthy, content, {}, openTo(0.0));
    for (std::size_t i = 0; i < 2; ++i) {
        VERIFY_WITHIN(inCmH2O(moment.pleural[i]), -5.0, kPressureTolerance_cmH2O);
        VERIFY_WITHIN(inCmH2O(moment.alveolar[i]), 0.0, kPressureTolerance_cmH2O);
    }
    VERIFY_WITHIN(inLitresPerSecond(moment.airwayFlow), 0.0, 1e-6);
}

/// A step of pressure P fills V(t) = P C (1 - exp(-t / RC)): 0.1 and 0.1 L/cmH2O in series are
/// 0.05, with 2 + 4 cmH2O s/L a time constant of 0.3 s.
void TestLungDynamics::fillsAsAResistanceAndACompliance()
{
    const RespiratorySystem system = linear({});
    ChestContent content = restingContent(system);
    for (int step = 1; step <= 1000; ++step) {
        content = advanced(system, content, kRelaxed, openTo(10.0), kStep);
        const double expected_l = 0.5 * (1.0 - std::exp(-step * kStep / 0.3));
        VERIFY_WITHIN(gasAboveRest_l(system, content), expected_l, kVolumeTolerance_l);
        const ChestMoment moment = chestMoment(system, content, {}, openTo(10.0));
        VERIFY_WITHIN(inLitresPerSecond(moment.airwayFlow),
                      10.0 / 6.0 * std::exp(-step * kStep / 0.3), 1e-5);
    }
}

/// In equal times equal ratios go out: a half every 0.3 s ln 2.
void TestLungDynamics::emptiesExponentially()
{
    const RespiratorySystem system = linear({});
    ChestContent content = restingContent(system);
    content[0].gas = content[0].gas + litres(0.4);
    content[1].gas = content[1].gas + litres(0.4);
    const double half = 0.3 * std::numbers::ln2;
    double left_l = 0.8;
    for (int i = 0; i < 6; ++i) {
        content = held(system, content, openTo(0.0), 100, half / 100.0);
        left_l *= 0.5;
        VERIFY_WITHIN(gasAboveRest_l(system, content), left_l, kVolumeTolerance_l);
    }
}

/// In with 2 + 4, out with 2 + 3 x 4 cmH2O s/L: time constants of 0.3 and 0.7 s. Under PEEP too.
void TestLungDynamics::emptiesLongerThroughCompressedBronchi()
{
    RespiratorySystem system = linear({});
    for (LungMechanics& lung : system.lungs)
        lung.compression = 3.0;
    ChestContent content = restingContent(system);
    content = held(system, content, openTo(10.0), 150, kStep);
    const double full_l = 0.5 * (1.0 - std::exp(-0.3 / 0.3));
    VERIFY_WITHIN(gasAboveRest_l(system, content), full_l, kVolumeTolerance_l);
    content = held(system, content, openTo(2.0), 350, kStep);
    VERIFY_WITHIN(gasAboveRest_l(system, content), 0.1 + (full_l - 0.1) * std::exp(-0.7 / 0.7),
                  kVolumeTolerance_l);
    const ChestMoment moment = chestMoment(system, content, {}, openTo(2.0));
    VERIFY_WITHIN(moment.airwayFlow.si, moment.intoLung[0].si + moment.intoLung[1].si, 1e-15);
}

void TestLungDynamics::sharesGasByCompliance()
{
    LinearChest chest;
    chest.rightShare = 0.7;
    const RespiratorySystem system = linear(chest);
    const ChestContent rest = restingContent(system);
    const ChestContent full = held(system, rest, openTo(10.0), 5000, kStep);
    VERIFY_WITHIN(inLitres(full[0].gas - rest[0].gas), 0.35, kVolumeTolerance_l);
    VERIFY_WITHIN(inLitres(full[1].gas - rest[1].gas), 0.15, kVolumeTolerance_l);
}

/// Bronchi alone between opening and lungs: each side fills with a time constant of its own.
void TestLungDynamics::fillsTheFasterLungFirst()
{
    LinearChest chest;
    chest.upper = 0.0;
    RespiratorySystem system = linear(chest);
    system.lungs[1].bronchi = 0.25 * system.lungs[1].bronchi; // 32 instead of 8 cmH2O s/L
    const ChestContent rest = restingContent(system);
    const ChestContent content = held(system, rest, openTo(10.0), 150, kStep);
    VERIFY_WITHIN(inLitres(content[0].gas - rest[0].gas), 0.25 * (1.0 - std::exp(-0.3 / 0.2)),
                  kVolumeTolerance_l);
    VERIFY_WITHIN(inLitres(content[1].gas - rest[1].gas), 0.25 * (1.0 - std::exp(-0.3 / 0.8)),
                  kVolumeTolerance_l);
}

/// Of a pressure held, the wall and the lung take parts as their elastances.
void TestLungDynamics::holdsTheCompliancesInSeries()
{
    LinearChest chest;
    chest.lungCompliance = 0.05;
    chest.wallCompliance = 0.2;
    const RespiratorySystem system = linear(chest);
    const ChestContent full = held(system, restingContent(system), openTo(10.0), 5000, kStep);
    VERIFY_WITHIN(gasAboveRest_l(system, full), 0.4, kVolumeTolerance_l);
    const ChestMoment moment = chestMoment(system, full, {}, openTo(10.0));
    VERIFY_WITHIN(inCmH2O(moment.pleural[0]), -5.0 + 2.0, kPressureTolerance_cmH2O);
    VERIFY_WITHIN(inCmH2O(moment.alveolar[0]), 10.0, kPressureTolerance_cmH2O);
}

/// The difference of opening and carina is K1 Q + K2 Q |Q|, in both directions.
void TestLungDynamics::losesPressureToLaminarAndTurbulentFlow()
{
    RespiratorySystem system = linear({});
    system.upperTurbulent = cmH2O(5.0).si / 1e-6; // 5 cmH2O at 1 L/s
    const ChestContent content = restingContent(system);
    for (const double p_cmH2O : {-12.0, -1.0, 0.5, 3.0, 30.0}) {
        const ChestMoment moment = chestMoment(system, content, {}, openTo(p_cmH2O));
        const double flow = inLitresPerSecond(moment.airwayFlow);
        QVERIFY(flow * p_cmH2O > 0.0);
        VERIFY_WITHIN(inCmH2O(moment.opening - moment.carina),
                      2.0 * flow + 5.0 * flow * std::abs(flow), kPressureTolerance_cmH2O);
        VERIFY_WITHIN(inCmH2O(moment.carina), 4.0 * flow, kPressureTolerance_cmH2O);
        VERIFY_WITHIN(inCmH2O(moment.opening), p_cmH2O, kPressureTolerance_cmH2O);
    }
}

/// At rest 6 cmH2O s/L take 3 cmH2O for 0.5 L/s; where only 1.2 are allowed, 0.2 L/s flow.
void TestLungDynamics::drivesAFlowUpToItsLimit()
{
    const RespiratorySystem system = linear({});
    const ChestContent content = restingContent(system);
    const auto driven = [&](double limit_cmH2O) {
        return chestMoment(system, content, {},
                           AirwayOpening::driven(litresPerSecond(0.5), cmH2O(limit_cmH2O)));
    };
    VERIFY_WITHIN(inLitresPerSecond(driven(40.0).airwayFlow), 0.5, 1e-9);
    VERIFY_WITHIN(inCmH2O(driven(40.0).opening), 3.0, kPressureTolerance_cmH2O);
    VERIFY_WITHIN(inLitresPerSecond(driven(1.2).airwayFlow), 0.2, 1e-6);
    VERIFY_WITHIN(inCmH2O(driven(1.2).opening), 1.2, kPressureTolerance_cmH2O);
}

void TestLungDynamics::drivesNothingIntoAClosedAirway()
{
    RespiratorySystem system = linear({});
    system.lungs[0].bronchi = {};
    system.lungs[1].bronchi = {};
    const ChestContent content = restingContent(system);
    for (const AirwayOpening& opening :
         {openTo(30.0), AirwayOpening::driven(litresPerSecond(0.5), cmH2O(30.0))}) {
        const ChestMoment moment = chestMoment(system, content, {}, opening);
        QCOMPARE(moment.airwayFlow.si, 0.0);
        QCOMPARE(moment.opening, cmH2O(30.0));
        QCOMPARE(moment.carina, cmH2O(30.0));
        QVERIFY(advanced(system, content, kRelaxed, opening, kStep) == content);
    }
}

void TestLungDynamics::givesAllToTheOpenSide()
{
    RespiratorySystem system = linear({});
    system.lungs[1].bronchi = {};
    const ChestContent rest = restingContent(system);
    const ChestContent full = held(system, rest, openTo(10.0), 5000, kStep);
    VERIFY_WITHIN(inLitres(full[0].gas - rest[0].gas), 0.25, kVolumeTolerance_l);
    QVERIFY(full[1] == rest[1]);
}

/// The equation of motion at rest: a pressure of the muscles held is worth one at the opening.
void TestLungDynamics::pullsInWhatTheMusclesPull()
{
    const RespiratorySystem system = linear({});
    ChestContent content = restingContent(system);
    const Pressure pull = cmH2O(8.0);
    const ChestMoment first = chestMoment(system, content, pull, openTo(0.0));
    VERIFY_WITHIN(inCmH2O(first.alveolar[0]), -8.0, kPressureTolerance_cmH2O);
    VERIFY_WITHIN(inCmH2O(first.pleural[0]), -13.0, kPressureTolerance_cmH2O);
    for (int i = 0; i < 5000; ++i)
        content = advanced(system, content, {pull, pull, pull}, openTo(0.0), kStep);
    VERIFY_WITHIN(gasAboveRest_l(system, content), 0.4, kVolumeTolerance_l);
}

CARINA_TEST(TestLungDynamics)

} // namespace carina::lung_dynamics_test

#include "tst_lung_dynamics.moc"
