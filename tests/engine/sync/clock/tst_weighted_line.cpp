#include "engine/sync/clock/weighted_line.h"
#include "tests/support/test_class.h"

#include <cmath>

namespace carina::weighted_line_test
{
namespace
{

constexpr double kTolerance = 1e-12;
constexpr double kNoPrior = 1e9; // a slope of any size is as likely

bool isNear(double a, double b) { return std::abs(a - b) <= kTolerance; }

} // namespace

class TestWeightedLine : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void findsTheLineThroughPointsOnOne()
    {
        WeightedLine line;
        for (const double x : {-4.0, -3.0, -1.0, 0.5})
            line.add({x, 2.0 - 0.25 * x, 1.0 + x * x});
        const auto fit = line.fit(1e-3);
        QVERIFY(isNear(fit.atZero, 2.0));
        QVERIFY(isNear(fit.slope, -0.25));
        QVERIFY(fit.error < 1e-9);
    }

    void weightsCountAsRepeatedPoints()
    {
        WeightedLine weighted;
        weighted.add({-2.0, 1.0, 3.0});
        weighted.add({-1.0, 4.0, 1.0});
        weighted.add({0.0, 2.0, 2.0});
        WeightedLine repeated;
        for (int i = 0; i < 3; ++i)
            repeated.add({-2.0, 1.0, 1.0});
        repeated.add({-1.0, 4.0, 1.0});
        for (int i = 0; i < 2; ++i)
            repeated.add({0.0, 2.0, 1.0});
        QVERIFY(isNear(weighted.fit(kNoPrior).atZero, repeated.fit(kNoPrior).atZero));
        QVERIFY(isNear(weighted.fit(kNoPrior).slope, repeated.fit(kNoPrior).slope));
    }

    void holdsTheSlopeToTheInformationInThePoints()
    {
        // x -1 0 1 0, y 1 0 3 0 of weight 1: means 0 and 1, S = 2, sum (x - x_m)(y - y_m) = 2, free
        // slope 1, residual 6 - 2 = 4, variance of a point 4/4 * 4/(4 - 2) = 2. With a prior of 1
        // the slope is 2 / (2 + 2/1) = 1/2.
        WeightedLine line;
        line.add({-1.0, 1.0});
        line.add({0.0, 0.0});
        line.add({1.0, 3.0});
        line.add({0.0, 0.0});
        QVERIFY(isNear(line.fit(kNoPrior).slope, 1.0));
        QVERIFY(isNear(line.fit(1.0).slope, 0.5));
        QVERIFY(isNear(line.fit(1.0).atZero, 1.0));
        // At x = x_m the error is that of a mean of four: sqrt(2 / 4).
        QVERIFY(isNear(line.fit(1.0).error, std::sqrt(0.5)));
    }

    void errorGrowsAwayFromThePoints()
    {
        // The same points 3 to the left: (2/4 + 9 * 2/(2 + 2)) under the root.
        WeightedLine line;
        line.add({-4.0, 1.0});
        line.add({-3.0, 0.0});
        line.add({-2.0, 3.0});
        line.add({-3.0, 0.0});
        QVERIFY(isNear(line.fit(1.0).atZero, 1.0 + 3.0 * 0.5));
        QVERIFY(isNear(line.fit(1.0).error, std::sqrt(0.5 + 4.5)));
    }

    void onePointHasNoSlope()
    {
        WeightedLine line;
        line.add({-5.0, 3.0, 0.5});
        const auto fit = line.fit(1.0);
        QCOMPARE(fit.atZero, 3.0);
        QCOMPARE(fit.slope, 0.0);
        QCOMPARE(fit.error, 0.0);
    }
};

CARINA_TEST(TestWeightedLine)

} // namespace carina::weighted_line_test

#include "tst_weighted_line.moc"
