#include "apps/lab/soak/trend.h"
#include "tests/support/test_class.h"

#include <cmath>
#include <random>
#include <vector>

namespace carina::trend_test
{

using carina::lab::leastOfEach;
using carina::lab::TimedFigure;
using carina::lab::Trend;
using carina::lab::trendOf;

namespace
{

constexpr double kSlope = 0.3;
constexpr int kFigures = 600;

/// A line with deviations of variance 1, each correlated with the one before.
std::vector<TimedFigure> noisyLine(double correlation, std::mt19937& random)
{
    std::normal_distribution<double> normal;
    std::vector<TimedFigure> figures;
    double deviation = normal(random);
    for (int i = 0; i < kFigures; ++i) {
        const double time = 0.1 * i;
        figures.push_back({time, 5.0 + kSlope * time + deviation});
        deviation =
            correlation * deviation + std::sqrt(1.0 - correlation * correlation) * normal(random);
    }
    return figures;
}

} // namespace

class TestTrend : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void findsTheSlopeOfALineExactly()
    {
        const std::vector<TimedFigure> line{{0.0, 1.0}, {1.0, 3.0}, {2.0, 5.0}, {4.0, 9.0}};
        const Trend trend = trendOf(line);
        QVERIFY(std::abs(trend.slope - 2.0) < 1e-12);
        QVERIFY(trend.standardError < 1e-12);
    }

    void leastOfEachPartIsWithoutThePeaks()
    {
        std::vector<TimedFigure> figures;
        for (int i = 0; i <= 100;
             ++i) // a level of 5, of which every seventh second something rises
            figures.push_back({double(i), 5.0 + kSlope * i + 40.0 * (i % 7)});
        const std::vector<TimedFigure> least = leastOfEach(figures, 10);
        QCOMPARE(least.size(), std::size_t{10});
        for (std::size_t part = 0; part < least.size(); ++part) {
            QVERIFY(least[part].time >= 10.0 * double(part));
            QVERIFY(least[part].time < 10.0 * double(part + 1) || part == 9);
        }
        const Trend trend = trendOf(least);
        QVERIFY(std::abs(trend.slope - kSlope) < 1e-12 && trend.standardError < 1e-12);
    }

    void isOneOverTheSpreadOfTheTimesForIndependentFigures()
    {
        std::mt19937 random{7};
        const Trend trend = trendOf(noisyLine(0.0, random));
        // sum (t - mean)^2 of n times that are h apart is h^2 n (n^2 - 1) / 12.
        const double spread = 0.01 * kFigures * (double{kFigures} * kFigures - 1.0) / 12.0;
        QVERIFY(std::abs(trend.standardError * std::sqrt(spread) - 1.0) < 0.15);
    }

    void saysHowFarTheSlopeMayBeOff_data()
    {
        QTest::addColumn<double>("correlation");
        QTest::newRow("independent figures") << 0.0;
        QTest::newRow("figures that change slowly") << 0.9;
    }

    /// Of slopes 95 % are within 1.96 standard errors of the true one. A few less than that are
    /// asked for, since correlation and variance are estimated, too.
    void saysHowFarTheSlopeMayBeOff()
    {
        QFETCH(double, correlation);
        constexpr int kTrials = 400;
        std::mt19937 random{7};
        int within = 0;
        for (int trial = 0; trial < kTrials; ++trial) {
            const Trend trend = trendOf(noisyLine(correlation, random));
            within += std::abs(trend.slope - kSlope) < 1.96 * trend.standardError ? 1 : 0;
        }
        QVERIFY2(within > 0.9 * kTrials && within < 0.99 * kTrials,
                 qPrintable(QString::number(within)));
    }
};

CARINA_TEST(TestTrend)

} // namespace carina::trend_test

#include "tst_trend.moc"
