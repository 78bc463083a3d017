#include "tests/engine/physiology/bed.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <cmath>

namespace carina::body_checkpoint_test
{

namespace
{

using test::Bed;

/// An induction, a difficult laryngoscopy, a tube that is too deep, and another patient.
void change(Bed& bed, int second)
{
    if (second == 2)
        bed.holdMask(0.8);
    if (second == 20)
        bed.body.give({DrugKind::Propofol, 150.0});
    if (second == 24)
        bed.body.give({DrugKind::Rocuronium, 60.0});
    if (second == 45)
        bed.stopBreathing();
    if (second == 50) {
        bed.care.bladeInMouth = true;
        bed.care.gas.maskHeld = false;
        bed.apply();
    }
    if (second == 70) {
        bed.care.bladeInMouth = false;
        bed.intubate(TubeSeat::RightMain, 1.0);
        bed.squeezeBag(14.0, 400.0);
        bed.letLungsSuffer({{ConditionKind::MainstemIntubation, 1.0, ConditionSide::Right},
                            {ConditionKind::Asthma, 0.4, ConditionSide::Both}});
    }
    if (second == 85) {
        bed.lungs.build = bed.care.build = test::kTwelve;
        bed.apply();
    }
}

void live(Bed& bed, int from_s, int to_s)
{
    for (int second = from_s; second < to_s; ++second) {
        change(bed, second);
        bed.run(1.0);
    }
}

/// Largest change of what a monitor shows as a number, in parts of its usual size.
double jump(const Vitals& before, const Vitals& after)
{
    double most = std::abs(after.arterialSaturation - before.arterialSaturation);
    most =
        std::max(most, std::abs(after.saturation.value_or(0.0) - before.saturation.value_or(0.0)));
    most = std::max(most, std::abs((after.mean - before.mean) / mmHg(90.0)));
    most = std::max(most, std::abs((after.systolic - before.systolic) / mmHg(120.0)));
    return std::max(most, std::abs((after.heartRate - before.heartRate) / perMinute(80.0)));
}

} // namespace

class TestBodyCheckpoint : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isTheSameBitForBit();
    void goesOnFromACheckpointBitForBit_data();
    void goesOnFromACheckpointBitForBit();
    void doesNotJumpWithSettings();
};

void TestBodyCheckpoint::isTheSameBitForBit()
{
    Bed first{test::kLeanAdult};
    Bed second{test::kLeanAdult};
    live(first, 0, 100);
    live(second, 0, 100);
    QVERIFY(first.body.state() == second.body.state());
    QVERIFY(first.body.vitals() == second.body.vitals());
    QCOMPARE(first.body.state().steps, std::int64_t{100 * 50});
}

void TestBodyCheckpoint::goesOnFromACheckpointBitForBit_data()
{
    QTest::addColumn<int>("second");
    QTest::newRow("before anything") << 0;
    QTest::newRow("as drugs spread") << 27;
    QTest::newRow("in apnoea") << 55;
    QTest::newRow("with one lung") << 80;
    QTest::newRow("as another patient") << 90;
}

void TestBodyCheckpoint::goesOnFromACheckpointBitForBit()
{
    QFETCH(const int, second);
    Bed whole{test::kLeanAdult};
    live(whole, 0, second);
    Bed restored = whole;
    restored.breathing = RespiratoryFold{whole.breathing.settings(), whole.breathing.state()};
    restored.body = BodyFold{whole.body.settings(), whole.body.state()};
    QVERIFY(restored.body.vitals() == whole.body.vitals());
    live(whole, second, 100);
    live(restored, second, 100);
    QVERIFY(restored.body.state() == whole.body.state());
    QVERIFY(restored.body.vitals() == whole.body.vitals());
}

void TestBodyCheckpoint::doesNotJumpWithSettings()
{
    constexpr double kStep = 0.012; // of 20 ms
    Bed bed{test::kLeanAdult};
    for (int second = 0; second < 100; ++second) {
        Vitals before = bed.body.vitals();
        change(bed, second);
        QVERIFY2(jump(before, bed.body.vitals()) < kStep, qPrintable(QString::number(second)));
        bed.runWhile(1.0, [&] {
            const Vitals after = bed.body.vitals();
            const bool isSmooth = jump(before, after) < kStep;
            before = after;
            return isSmooth;
        });
        QCOMPARE(bed.body.state().steps, std::int64_t{(second + 1) * 50});
    }
}

CARINA_TEST(TestBodyCheckpoint)

} // namespace carina::body_checkpoint_test

#include "tst_body_checkpoint.moc"
