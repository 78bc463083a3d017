#include "engine/physiology/oximeter.h"
#include "tests/engine/physiology/bed.h"
#include "tests/support/test_class.h"

namespace carina::oximeter_test
{

namespace
{

using test::Bed;

} // namespace

/// The saturation as a finger probe shows it.
class TestOximeter : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isTenToFifteenSecondsLate();
    void keepsASteadyValue();
    void showsNothingWithoutProbe();
    void showsNothingWithoutPulse();
};

void TestOximeter::isTenToFifteenSecondsLate()
{
    Bed bed{test::kLeanAdult};
    bed.holdMask(1.0);
    bed.run(180.0);
    bed.care.gas.maskHeld = false;
    bed.stopBreathing();
    bed.runWhile(900.0, [&] { return bed.saturation() > 0.90; });
    const double late_s =
        bed.runWhile(60.0, [&] { return bed.body.vitals().saturation.value_or(0.0) > 0.90; });
    QVERIFY2(late_s >= 10.0 && late_s <= 15.0, qPrintable(QString::number(late_s)));
}

void TestOximeter::keepsASteadyValue()
{
    OximeterState state = settledAt(0.93);
    for (int i = 0; i < 5000; ++i) {
        watch(state, 0.93, kBodyStep);
        QVERIFY(std::abs(state.shown - 0.93) < 1e-12);
    }
}

void TestOximeter::showsNothingWithoutProbe()
{
    Bed bed{test::kLeanAdult};
    bed.run(5.0);
    QVERIFY(bed.body.vitals().saturation.has_value());
    bed.care.gas.probeOn = false;
    bed.apply();
    bed.run(1.0);
    QVERIFY(!bed.body.vitals().saturation);
    QVERIFY(!bed.body.vitals().probeIsOn);
    QCOMPARE(bed.body.vitals().pulseWave, 0.0);
    bed.care.gas.probeOn = true;
    bed.apply();
    bed.run(1.0);
    QVERIFY(bed.body.vitals().saturation.has_value());
}

void TestOximeter::showsNothingWithoutPulse()
{
    Bed bed{test::kLeanAdult};
    bed.stopBreathing();
    bed.runWhile(900.0, [&] { return !bed.body.state().circulation.arrested; });
    bed.run(5.0);
    QVERIFY(bed.body.state().circulation.arrested);
    QVERIFY(!bed.body.vitals().saturation);
    QVERIFY(bed.body.vitals().probeIsOn);
    QCOMPARE(bed.body.breathingLeft(), 0.0);
    QCOMPARE(bed.body.vitals().heartRate.si, 0.0);
    QCOMPARE(bed.body.vitals().electrocardiogram, 0.0);
    QVERIFY(bed.mean_mmHg() < 45.0);
}

CARINA_TEST(TestOximeter)

} // namespace carina::oximeter_test

#include "tst_oximeter.moc"
