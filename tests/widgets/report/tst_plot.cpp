#include "tests/support/test_class.h"
#include "widgets/report/plot.h"

#include <cmath>
#include <limits>

namespace carina::plot_test
{
namespace
{

constexpr double kRoundingError = 1e-12;

bool isAbout(double a, double b) { return std::abs(a - b) < kRoundingError; }

Plot plotOfPoints(std::vector<QPointF> marks, std::vector<QPointF> line)
{
    return {.series = {{.marks = std::move(marks)}, {.line = std::move(line)}}};
}

} // namespace

class PlotTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void scalesHoldMarksAndLines()
    {
        const Plot plot = plotOfPoints({{1.0, 1.0}}, {{3.0, 8.5}});
        QVERIFY(isAbout(xScaleOf(plot).least(), 1.0));
        QVERIFY(isAbout(xScaleOf(plot).greatest(), 3.0));
        QVERIFY(isAbout(yScaleOf(plot).least(), 0.0));
        QVERIFY(isAbout(yScaleOf(plot).greatest(), 10.0));
    }

    void zeroIsShownWhereItIsAskedFor_data()
    {
        QTest::addColumn<double>("number");
        QTest::addColumn<double>("least");
        QTest::addColumn<double>("greatest");
        QTest::newRow("above") << 8.5 << 0.0 << 10.0;
        QTest::newRow("below") << -8.5 << -10.0 << 0.0;
    }
    void zeroIsShownWhereItIsAskedFor()
    {
        QFETCH(double, number);
        QFETCH(double, least);
        QFETCH(double, greatest);
        Plot plot = plotOfPoints({{1.0, number}, {2.0, 1.05 * number}}, {});
        QVERIFY(yScaleOf(plot).least() * yScaleOf(plot).greatest() > 0.0);
        plot.y.showsZero = true;
        QVERIFY(isAbout(yScaleOf(plot).least(), least));
        QVERIFY(isAbout(yScaleOf(plot).greatest(), greatest));
    }

    void scalesOfNothingAreScalesYet()
    {
        Plot plot;
        QVERIFY(isAbout(yScaleOf(plot).least(), 0.0));
        QVERIFY(isAbout(yScaleOf(plot).greatest(), 1.0));
        plot.y.isLogarithmic = true;
        QCOMPARE(yScaleOf(plot).least(), 1.0);
        QCOMPARE(yScaleOf(plot).greatest(), 10.0);
    }

    void whatCannotBeShownHasNoSayInTheScale()
    {
        const double infinity = std::numeric_limits<double>::infinity();
        Plot plot = plotOfPoints({{1.0, std::nan("")}, {1.0, infinity}}, {{1.0, 2.0}, {1.0, 8.0}});
        QVERIFY(isAbout(yScaleOf(plot).greatest(), 8.0));
        plot.series[0].marks = {{1.0, 0.0}, {1.0, -3.0}};
        plot.y.isLogarithmic = true;
        QCOMPARE(yScaleOf(plot).least(), 1.0);
        QCOMPARE(yScaleOf(plot).greatest(), 10.0);
    }
};

CARINA_TEST(PlotTest)

} // namespace carina::plot_test

#include "tst_plot.moc"
