#include "apps/lab/summary/breath_estimate.h"
#include "tests/support/test_class.h"

#include <cmath>
#include <numbers>
#include <vector>

namespace carina::breath_estimate_test
{

using carina::Duration;
using carina::LocalTime;
using carina::lab::BreathEstimate;
using carina::lab::estimateBreathing;
using carina::lab::VolumeSample;

namespace
{

/// A pure sine of known rate and stroke, sampled at 60 Hz.
std::vector<VolumeSample> sine(double rate_per_min, double stroke_ml, double seconds)
{
    std::vector<VolumeSample> samples;
    for (int i = 0; i <= static_cast<int>(seconds * 60.0); ++i) {
        const double t = i / 60.0;
        const double phase = 2.0 * std::numbers::pi * rate_per_min / 60.0 * t;
        samples.push_back({LocalTime{carina::fromSeconds(t)},
                           2000.0 + 0.5 * stroke_ml * (1.0 - std::cos(phase))});
    }
    return samples;
}

} // namespace

class TestBreathEstimate : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void recoversRateAndStroke_data()
    {
        QTest::addColumn<double>("rate_per_min");
        QTest::addColumn<double>("stroke_ml");
        QTest::newRow("child at rest") << 19.0 << 280.0;
        QTest::newRow("slow and deep") << 12.0 << 800.0;
        QTest::newRow("fast and shallow") << 40.0 << 90.0;
    }

    void recoversRateAndStroke()
    {
        QFETCH(double, rate_per_min);
        QFETCH(double, stroke_ml);
        const auto estimate = estimateBreathing(sine(rate_per_min, stroke_ml, 30.0));
        QVERIFY(estimate.has_value());
        // A 60 Hz sample misses the turning point of a 40/min sine by at most 1 - cos(pi/45).
        constexpr double kTolerance = 0.003;
        QVERIFY(std::abs(inPerMinute(estimate->rate) / rate_per_min - 1.0) < kTolerance);
        QVERIFY(std::abs(inMillilitres(estimate->tidalVolume) / stroke_ml - 1.0) < kTolerance);
    }

    void countsWholeBreaths()
    {
        // The middle is crossed upwards at a quarter of each breath: four times in four breaths.
        const auto estimate = estimateBreathing(sine(15.0, 500.0, 16.0));
        QVERIFY(estimate.has_value());
        QCOMPARE(estimate->breaths, 3);
    }

    void saysNothingOfLungsThatStandStill()
    {
        std::vector<VolumeSample> still(100);
        for (int i = 0; i < 100; ++i)
            still[std::size_t(i)] = {LocalTime{Duration{i * 16'000'000}}, 2000.0};
        QVERIFY(!estimateBreathing(still).has_value());
        QVERIFY(!estimateBreathing({}).has_value());
    }

    void saysNothingOfLessThanOneBreath()
    {
        QVERIFY(!estimateBreathing(sine(15.0, 500.0, 3.5)).has_value());
    }
};

CARINA_TEST(TestBreathEstimate)

} // namespace carina::breath_estimate_test

#include "tst_breath_estimate.moc"
