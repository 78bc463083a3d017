#include "tests/support/test_class.h"
#include "widgets/vitals/sweep_curve.h"

#include <cmath>

namespace carina::sweep_curve_test
{
namespace
{

constexpr QRectF kFrame{10.0, 20.0, 200.0, 100.0};
constexpr double kPixel = 1e-6; ///< rounding, pixels

} // namespace

class TestSweepCurve : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isWrittenFromLeftToRight()
    {
        SweepCurve curve{10.0, 0.0, 2.0};
        QVERIFY(curve.lines(kFrame).empty());
        QVERIFY(!curve.bar(kFrame));
        curve.add(20.0, 0.0);
        curve.add(22.5, 1.0);
        const auto lines = curve.lines(kFrame);
        QCOMPARE(lines.size(), std::size_t{1});
        QVERIFY(std::abs(lines[0][0].x() - 10.0) < kPixel);
        QVERIFY(std::abs(lines[0][0].y() - 120.0) < kPixel);
        QVERIFY(std::abs(lines[0][1].x() - 60.0) < kPixel);
        QVERIFY(std::abs(lines[0][1].y() - 70.0) < kPixel);
        QVERIFY(std::abs(*curve.bar(kFrame) - 60.0) < kPixel);
    }

    void leavesAGapAheadOfTheBar()
    {
        SweepCurve curve{10.0, 0.0, 2.0};
        for (int i = 0; i < 1300; ++i)
            curve.add(0.01 * i, 1.0);
        const auto lines = curve.lines(kFrame);
        QCOMPARE(lines.size(), std::size_t{2});
        const double gap = (lines[0].first().x() - *curve.bar(kFrame)) / kFrame.width();
        QVERIFY2(std::abs(gap - SweepCurve::kGapShare) < 0.002, qPrintable(QString::number(gap)));
    }

    void isInterruptedWhereNothingIsMeasured()
    {
        SweepCurve curve{10.0, 0.0, 2.0};
        curve.add(1.0, 1.0);
        curve.add(2.0, 1.0);
        curve.add(3.0, std::nullopt);
        curve.add(4.0, 1.0);
        const auto lines = curve.lines(kFrame);
        QCOMPARE(lines.size(), std::size_t{2});
        QCOMPARE(lines[0].size(), 2);
        QCOMPARE(lines[1].size(), 1);
        curve.add(5.0, std::nullopt);
        QVERIFY(std::abs(*curve.bar(kFrame) - 110.0) < kPixel); // and the bar goes on
    }

    void beginsAnewAfterALongGapAndAfterAStepBack()
    {
        SweepCurve curve{10.0, 0.0, 2.0};
        curve.add(1.0, 1.0);
        curve.add(2.0, 1.0);
        curve.add(12.5, 1.0);
        QCOMPARE(curve.lines(kFrame).size(), std::size_t{1});
        QCOMPARE(curve.lines(kFrame)[0].size(), 1);
        curve.add(12.5, 1.0);
        QCOMPARE(curve.lines(kFrame)[0].size(), 1);
    }

    void staysWithinItsFrame()
    {
        SweepCurve curve{10.0, 0.0, 2.0};
        curve.add(1.0, 9.0);
        curve.add(2.0, -9.0);
        const QPolygonF line = curve.lines(kFrame)[0];
        QVERIFY(std::abs(line[0].y() - kFrame.top()) < kPixel);
        QVERIFY(std::abs(line[1].y() - kFrame.bottom()) < kPixel);
        curve.setTop(18.0);
        QVERIFY(std::abs(curve.lines(kFrame)[0][0].y() - 70.0) < kPixel);
    }
};

CARINA_SCREEN_TEST(TestSweepCurve)

} // namespace carina::sweep_curve_test

#include "tst_sweep_curve.moc"
