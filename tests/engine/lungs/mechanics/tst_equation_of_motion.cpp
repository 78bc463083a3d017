#include "engine/lungs/mechanics/lung_dynamics.h"

#include "tests/engine/lungs/drawing/chest_samples.h"
#include "tests/engine/lungs/drawing/reference_chest.h"
#include "tests/engine/lungs/mechanics/within.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <numbers>

namespace carina::equation_of_motion_test
{

using namespace carina::test;

namespace
{

ReferenceChest referenceOf(const RespiratorySystem& system, const ChestContent& content)
{
    ReferenceChest chest;
    for (std::size_t i = 0; i < 2; ++i) {
        const LungMechanics& lung = system.lungs[i];
        chest.lungs[i] = {inLitres(lung.curve.floor),
                          inLitres(lung.curve.span),
                          inCmH2O(lung.curve.centre),
                          inCmH2O(lung.curve.width),
                          inCmH2O(lung.limbSpread),
                          inLitres(lung.limbVolume),
                          inCmH2OSecondsPerLitre({1.0 / lung.bronchi.si}),
                          lung.compression,
                          inLitresPerCmH2O(lung.wall),
                          inLitres(lung.wallVolume),
                          inCmH2O(lung.wallRecoil),
                          inLitres(content[i].gas),
                          content[i].limb};
    }
    chest.k1 = inCmH2OSecondsPerLitre(system.upperLaminar);
    chest.k2 = system.upperTurbulent * 1e-6 / kPascalsPerCmH2O; // of (L/s)^2
    chest.mediastinum = inLitresPerCmH2O(system.mediastinum);
    return chest;
}

} // namespace

class TestEquationOfMotion : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void agreesWithAnotherIntegrator_data();
    void agreesWithAnotherIntegrator();
    void movesGasFromTheInspiredToTheLungs();
    void runsFromLimbToLimb();
    void losesWorkInALoopAndNoneWithoutOne();
};

void TestEquationOfMotion::agreesWithAnotherIntegrator_data()
{
    QTest::addColumn<double>("openShare"); // of the right lung
    QTest::addColumn<double>("tube_mm");   // 0: none
    QTest::addColumn<double>("pressure_cmH2O");
    QTest::addColumn<double>("muscle_cmH2O");
    QTest::addColumn<double>("compression"); // of the left lung; half as much of the right
    QTest::newRow("quiet breathing") << 1.0 << 0.0 << 0.0 << 11.0 << 1.0;
    QTest::newRow("through a tube") << 1.0 << 8.0 << 15.0 << 0.0 << 1.0;
    QTest::newRow("half a lung, a narrow tube, effort") << 0.5 << 5.5 << 20.0 << 6.0 << 1.0;
    QTest::newRow("unlike lungs with compressed bronchi") << 0.5 << 8.0 << 15.0 << 6.0 << 40.0;
}

/// The equation of motion solved twice: here in steps of 2 ms, there in steps a hundred times finer
/// and by another method.
void TestEquationOfMotion::agreesWithAnotherIntegrator()
{
    QFETCH(const double, openShare);
    QFETCH(const double, tube_mm);
    QFETCH(const double, pressure_cmH2O);
    QFETCH(const double, muscle_cmH2O);
    QFETCH(const double, compression);
    constexpr double kAgreement_l = 2e-6;
    constexpr double kFine = kStep / 100.0;
    constexpr int kBlock = 250; // steps at one pressure
    RespiratorySystem system = healthySystem({});
    system.lungs[0].curve.span = openShare * system.lungs[0].curve.span;
    system.lungs[0].compression = std::max(1.0, 0.5 * compression);
    system.lungs[1].compression = compression;
    if (tube_mm > 0.0)
        intubate(system, millimetres(tube_mm));
    ChestContent content = restingContent(system);
    ReferenceChest reference = referenceOf(system, content);
    const auto muscle = [&](double t) {
        return muscle_cmH2O * 0.5 * (1.0 - std::cos(2.0 * std::numbers::pi * t));
    };
    for (int block = 0; block < 4; ++block) {
        const double opening = block % 2 == 0 ? pressure_cmH2O : 0.0;
        const double from = block * kBlock * kStep;
        for (int i = 0; i < kBlock; ++i) {
            const double t = from + i * kStep;
            content = advanced(
                system, content,
                {cmH2O(muscle(t)), cmH2O(muscle(t + 0.5 * kStep)), cmH2O(muscle(t + kStep))},
                openTo(opening), kStep);
        }
        reference.run(
            from, 100 * kBlock, kFine, [&](double) { return opening; }, muscle);
        for (std::size_t i = 0; i < 2; ++i) {
            VERIFY_WITHIN(inLitres(content[i].gas), reference.lungs[i].gas, kAgreement_l);
            VERIFY_WITHIN(content[i].limb, reference.lungs[i].limb, 1e-5);
        }
    }
}

/// The flow at the opening, summed by Simpson's rule, is what the lungs gain.
void TestEquationOfMotion::movesGasFromTheInspiredToTheLungs()
{
    const RespiratorySystem system = healthySystem({});
    ChestContent content = restingContent(system);
    const double before = inLitres(content[0].gas + content[1].gas);
    double sum_l = 0.0;
    for (int i = 0; i < 400; ++i) {
        const auto flowNow = [&](const ChestContent& at) {
            return inLitresPerSecond(chestMoment(system, at, {}, openTo(12.0)).airwayFlow);
        };
        const double first = flowNow(content);
        const double middle =
            flowNow(advanced(system, content, kRelaxed, openTo(12.0), 0.5 * kStep));
        content = advanced(system, content, kRelaxed, openTo(12.0), kStep);
        sum_l += kStep / 6.0 * (first + 4.0 * middle + flowNow(content));
    }
    QVERIFY(sum_l > 1.0);
    VERIFY_WITHIN(inLitres(content[0].gas + content[1].gas) - before, sum_l, 1e-8);
}

/// Of the way to the limb of the flow, exp(-V/V0) is left after V has gone in or out.
void TestEquationOfMotion::runsFromLimbToLimb()
{
    RespiratorySystem system = healthySystem({});
    ChestContent content = restingContent(system);
    const ChestContent rest = content;
    content = held(system, content, openTo(15.0), 200, kStep);
    for (std::size_t i = 0; i < 2; ++i) {
        const double moved = (content[i].gas - rest[i].gas) / system.lungs[i].limbVolume;
        QVERIFY(moved > 0.5);
        VERIFY_WITHIN(content[i].limb, 0.5 * std::exp(-moved), 1e-6);
    }
    const ChestContent full = content;
    content = held(system, content, openTo(-5.0), 100, kStep);
    for (std::size_t i = 0; i < 2; ++i) {
        const double moved = (full[i].gas - content[i].gas) / system.lungs[i].limbVolume;
        QVERIFY(moved > 0.3);
        VERIFY_WITHIN(content[i].limb, 1.0 - (1.0 - full[i].limb) * std::exp(-moved), 1e-6);
    }
}

/// Work into the lung over a slow cycle: the integral of the pressure across it, by volume. Of a
/// steady cycle of V in and V out a spread h takes h (V - 2 V0 tanh(V / 2 V0)).
void TestEquationOfMotion::losesWorkInALoopAndNoneWithoutOne()
{
    for (const double spread_cmH2O : {0.0, 4.0}) {
        RespiratorySystem system = linear({});
        for (LungMechanics& lung : system.lungs)
            lung.limbSpread = cmH2O(spread_cmH2O);
        ChestContent content = restingContent(system);
        const AirwayOpening in = AirwayOpening::driven(litresPerSecond(1.0), cmH2O(1e3));
        const AirwayOpening out = AirwayOpening::driven(litresPerSecond(-1.0), cmH2O(1e3));
        double work = 0.0; // cmH2O L, right lung
        for (int cycle = 0; cycle < 8; ++cycle) {
            work = 0.0;
            for (int i = 0; i < 1000; ++i) {
                const AirwayOpening& opening = i < 500 ? in : out;
                const ChestMoment before = chestMoment(system, content, {}, opening);
                const ChestContent next = advanced(system, content, kRelaxed, opening, kStep);
                const ChestMoment after = chestMoment(system, next, {}, opening);
                work += 0.5
                        * inCmH2O(before.alveolar[0] - before.pleural[0] + after.alveolar[0]
                                  - after.pleural[0])
                        * inLitres(next[0].gas - content[0].gas);
                content = next;
            }
        }
        const double moved_l = 0.5; // of 1 L into both
        VERIFY_WITHIN(work, spread_cmH2O * (moved_l - 2.0 * std::tanh(moved_l / 2.0)), 1e-4);
    }
}

CARINA_TEST(TestEquationOfMotion)

} // namespace carina::equation_of_motion_test

#include "tst_equation_of_motion.moc"
