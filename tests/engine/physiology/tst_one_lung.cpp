#include "tests/engine/physiology/bed.h"
#include "tests/support/test_class.h"

namespace carina::one_lung_test
{

namespace
{

using test::Bed;

Bed ventilated(double oxygen)
{
    Bed bed{test::kLeanAdult};
    bed.stopBreathing();
    bed.intubate(TubeSeat::Trachea, oxygen);
    bed.squeezeBag(12.0, 500.0);
    bed.run(120.0);
    return bed;
}

void slipToTheRight(Bed& bed)
{
    bed.care.tube.seat = TubeSeat::RightMain;
    bed.letLungsSuffer({{ConditionKind::MainstemIntubation, 1.0, ConditionSide::Right}});
}

} // namespace

/// A tube in one main bronchus: the other lung's blood meets no fresh gas.
class TestOneLung : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void driftsWithinMinutes_data();
    void driftsWithinMinutes();
    void isHiddenByPureOxygenForMinutes();
    void recoversWhenTheTubeIsDrawnBack();
};

void TestOneLung::driftsWithinMinutes_data()
{
    QTest::addColumn<double>("oxygen");
    QTest::newRow("half oxygen") << 0.5;
    QTest::newRow("40 %") << 0.4;
}

// Not at once; 93 to 95 % after minutes (Pulse), as a monitor shows it in whole per cent, once
// hypoxic constriction has set in.
void TestOneLung::driftsWithinMinutes()
{
    QFETCH(const double, oxygen);
    Bed bed = ventilated(oxygen);
    QVERIFY(bed.saturation() > 0.98);
    slipToTheRight(bed);
    bed.run(60.0);
    QVERIFY2(bed.saturation() > 0.97, qPrintable(QString::number(bed.saturation())));
    bed.run(420.0);
    const double shown = bed.body.vitals().saturation.value_or(0.0);
    QVERIFY2(shown >= 0.925 && shown < 0.955, qPrintable(QString::number(shown)));
}

void TestOneLung::isHiddenByPureOxygenForMinutes()
{
    Bed bed = ventilated(1.0);
    slipToTheRight(bed);
    bed.run(240.0);
    QVERIFY(bed.saturation() > 0.99);
    bed.run(360.0);
    QVERIFY2(bed.saturation() < 0.985, qPrintable(QString::number(bed.saturation())));
}

void TestOneLung::recoversWhenTheTubeIsDrawnBack()
{
    Bed bed = ventilated(0.5);
    slipToTheRight(bed);
    bed.run(480.0);
    QVERIFY(bed.saturation() < 0.955);
    bed.care.tube.seat = TubeSeat::Trachea;
    bed.letLungsSuffer({});
    bed.run(120.0);
    QVERIFY2(bed.saturation() > 0.975, qPrintable(QString::number(bed.saturation())));
}

CARINA_TEST(TestOneLung)

} // namespace carina::one_lung_test

#include "tst_one_lung.moc"
