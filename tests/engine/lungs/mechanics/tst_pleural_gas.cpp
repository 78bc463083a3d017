#include "engine/lungs/mechanics/lung_dynamics.h"

#include "tests/engine/lungs/drawing/chest_samples.h"
#include "tests/engine/lungs/mechanics/within.h"
#include "tests/support/test_class.h"

namespace carina::pleural_gas_test
{

using namespace carina::test;

class TestPleuralGas : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void letsTheMediastinumGiveWay();
    void stopsTheMediastinumAtItsEnd();
    void countsThePleuralGas();
    void letsGasIntoThePleuraAndNotBack();
    void collapsesByTrappedGas();
    void neverReachesTheFloor();
    void letsTrappedGasOutAgain();
    void takesUpGasBehindABlock();
};

/// Pressures on both sides of a mediastinum of compliance M differ by what the walls make of it:
/// D0 / (1 + M (1/W + 1/W)), and the side that pushes takes the room.
void TestPleuralGas::letsTheMediastinumGiveWay()
{
    RespiratorySystem system = linear({});
    system.mediastinum = litresPerCmH2O(0.02);
    system.mediastinumMost = litres(10.0);
    const ChestContent rest = restingContent(system);
    system.lungs[0].pleuralGas = litres(0.6);
    const ChestMoment moment = chestMoment(system, rest, {}, openTo(0.0));
    // 0.6 L in a wall of 0.05 L/cmH2O is 12 cmH2O; 12 / (1 + 0.02 * 40).
    const double difference = 12.0 / 1.8;
    VERIFY_WITHIN(inCmH2O(moment.pleural[0] - moment.pleural[1]), difference,
                  kPressureTolerance_cmH2O);
    VERIFY_WITHIN(inLitres(moment.mediastinum), 0.02 * difference, kVolumeTolerance_l);
    VERIFY_WITHIN(inCmH2O(moment.pleural[1]), -5.0 + 0.02 * difference / 0.05,
                  kPressureTolerance_cmH2O);
}

void TestPleuralGas::stopsTheMediastinumAtItsEnd()
{
    RespiratorySystem system = linear({});
    system.mediastinum = litresPerCmH2O(0.02);
    system.mediastinumMost = litres(0.1);
    const ChestContent rest = restingContent(system);
    system.lungs[1].pleuralGas = litres(0.6);
    const ChestMoment moment = chestMoment(system, rest, {}, openTo(0.0));
    QCOMPARE(inLitres(moment.mediastinum), -0.1);
    VERIFY_WITHIN(inCmH2O(moment.pleural[1]), -5.0 + 12.0 - 2.0, kPressureTolerance_cmH2O);
    VERIFY_WITHIN(inCmH2O(moment.pleural[0]), -5.0 + 2.0, kPressureTolerance_cmH2O);
}

/// Gas in the pleura shares the side with the lung: each gives way by its compliance.
void TestPleuralGas::countsThePleuralGas()
{
    LinearChest chest;
    chest.wallCompliance = 0.3;
    RespiratorySystem system = linear(chest);
    const Volume before = restingContent(system)[0].gas;
    system.lungs[0].pleuralGas = litres(0.4);
    const ChestContent rest = restingContent(system);
    VERIFY_WITHIN(inLitres(before - rest[0].gas), 0.4 * 0.05 / (0.05 + 0.15), kVolumeTolerance_l);
    VERIFY_WITHIN(inLitres(rest[1].gas), 1.2, kVolumeTolerance_l);
}

/// Through a tear flows its conductance times the pressure of the carina above the pleura's.
void TestPleuralGas::letsGasIntoThePleuraAndNotBack()
{
    RespiratorySystem system = healthySystem({});
    system.lungs[0].valve = {1.0 / cmH2OSecondsPerLitre(100.0).si};
    system.lungs[0].relief = {};
    ChestContent content = restingContent(system);
    const ChestMoment atRest = chestMoment(system, content, {}, openTo(0.0));
    VERIFY_WITHIN(inLitresPerSecond(atRest.intoPleura[0]), (inCmH2O(atRest.carina) + 5.0) / 100.0,
                  1e-9);
    QCOMPARE(atRest.intoPleura[1].si, 0.0);
    VERIFY_WITHIN(inLitresPerSecond(atRest.airwayFlow),
                  inLitresPerSecond(atRest.intoLung[0]) + inLitresPerSecond(atRest.intoLung[1])
                      + inLitresPerSecond(atRest.intoPleura[0]),
                  1e-9);
    content[0].trapped = litres(2.5);                          // of a wall of 0.105 L/cmH2O
    content = held(system, content, openTo(0.0), 1000, kStep); // the lung gives way
    const ChestMoment tense = chestMoment(system, content, {}, openTo(0.0));
    QVERIFY(tense.pleural[0] > tense.carina);
    QCOMPARE(tense.intoPleura[0].si, 0.0);
    RespiratorySystem whole = system;
    whole.lungs[0].valve = {};
    QCOMPARE(tense.carina, chestMoment(whole, content, {}, openTo(0.0)).carina);
    QCOMPARE(held(system, content, openTo(0.0), 500, kStep)[0].trapped, content[0].trapped);
}

/// Half the resting volume of trapped gas leaves half of the lung's span, and as much of its
/// bronchi.
void TestPleuralGas::collapsesByTrappedGas()
{
    const RespiratorySystem system = healthySystem({});
    const LungMechanics& lung = system.lungs[0];
    ChestContent content = restingContent(system);
    content[0].trapped = 0.5 * lung.wallVolume;
    const ChestMoment moment = chestMoment(system, content, {}, openTo(0.0));
    const double share = (content[0].gas - lung.curve.floor) / (0.5 * lung.curve.span);
    VERIFY_WITHIN(inCmH2O(moment.alveolar[0] - moment.pleural[0]),
                  inCmH2O(lung.curve.centre)
                      + inCmH2O(lung.curve.width) * std::log(share / (1.0 - share)),
                  kPressureTolerance_cmH2O);
    VERIFY_WITHIN(moment.intoLung[0].si / (moment.carina - moment.alveolar[0]).si,
                  0.5 * lung.bronchi.si, 1e-15);
}

void TestPleuralGas::neverReachesTheFloor()
{
    const RespiratorySystem system = healthySystem({});
    ChestContent content = restingContent(system);
    for (int second = 0; second < 20; ++second) {
        content = held(system, content, openTo(-60.0), 500, kStep);
        for (std::size_t i = 0; i < 2; ++i)
            QVERIFY(content[i].gas > system.lungs[i].curve.floor);
    }
    VERIFY_WITHIN(inLitres(content[0].gas), inLitres(system.lungs[0].curve.floor), 0.01);
    // And it fills again.
    content = held(system, content, openTo(0.0), 5000, kStep);
    VERIFY_WITHIN(inLitres(content[0].gas), 0.525 * 2.31, 0.12); // on its inflation limb
}

void TestPleuralGas::letsTrappedGasOutAgain()
{
    RespiratorySystem system = linear({});
    system.lungs[1].relief = hertz(0.5);
    ChestContent content = restingContent(system);
    content[1].trapped = litres(1.0);
    content = held(system, content, openTo(0.0), 1000, kStep);
    VERIFY_WITHIN(inLitres(content[1].trapped), std::exp(-1.0), 1e-9);
}

/// Behind a block the blood takes gas up exponentially to what it leaves.
void TestPleuralGas::takesUpGasBehindABlock()
{
    RespiratorySystem system = linear({});
    system.lungs[0].bronchi = {};
    system.lungs[0].uptake = hertz(0.1);
    system.lungs[0].uptakeEnd = litres(0.7);
    ChestContent content = restingContent(system);
    content = held(system, content, openTo(0.0), 5000, kStep);
    VERIFY_WITHIN(inLitres(content[0].gas), 0.7 + 0.5 * std::exp(-1.0), 1e-9);
    content[0].gas = litres(0.6);
    QCOMPARE(held(system, content, openTo(0.0), 10, kStep)[0].gas, litres(0.6));
}

CARINA_TEST(TestPleuralGas)

} // namespace carina::pleural_gas_test

#include "tst_pleural_gas.moc"
