#include "engine/airway/monitor/crossing.h"
#include "tests/support/test_class.h"

#include <cmath>
#include <vector>

namespace carina::crossing_test
{

namespace
{

using std::chrono::milliseconds;

constexpr CrossingRule kRule{
    .band = 2.0, .sure = 8.0, .dwellIn = milliseconds{100}, .dwellOut = milliseconds{300}};
constexpr double kExact = 1e-6; // of what is interpolated, in seconds or metres

TipReading at(int time_ms, double depth_mm = 0.0)
{
    return {.at = SessionTime{milliseconds{time_ms}}, .depthAtTeeth = millimetres(depth_mm)};
}

double secondsOf(const Passage& passage)
{
    return toSeconds(passage.reading.at.time_since_epoch());
}

/// The passages of values that are 20 ms apart.
std::vector<Passage> passagesOf(Crossing& crossing, const std::vector<double>& values,
                                const CrossingRule& rule = kRule)
{
    std::vector<Passage> found;
    int time = 0;
    for (const double value : values)
        if (const auto passage = crossing.take(value, at(time++ * 20, 10.0 + value), rule))
            found.push_back(*passage);
    return found;
}

} // namespace

class TestCrossing : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void timeAndDepthAreThoseOfZero()
    {
        Crossing crossing;
        const auto found = passagesOf(crossing, {-3.0, -1.0, 3.0, 4.0, 5.0, 6.0, 7.0, 7.0, 7.0});
        QCOMPARE(found.size(), 1U);
        QVERIFY(found.front().isIn && crossing.isIn && !found.front().wasUnseen);
        QVERIFY(std::abs(secondsOf(found.front()) - 0.025) < kExact);
        QVERIFY(std::abs(inMillimetres(found.front().reading.depthAtTeeth) - 10.0) < kExact);
    }

    void noiseAboutZeroIsNoPassage()
    {
        Crossing crossing;
        std::vector<double> values;
        for (int i = 0; i < 200; ++i)
            values.push_back(1.9 * std::sin(2.1 * i));
        QVERIFY(passagesOf(crossing, values).empty());
    }

    /// 100 ms beyond the band are six samples.
    void bandIsLeftForAWhile()
    {
        Crossing short_;
        QVERIFY(passagesOf(short_, {-3.0, 3.0, 3.0, 3.0, 3.0, 3.0, 1.0, 1.0, 1.0}).empty());
        Crossing long_;
        QCOMPARE(passagesOf(long_, {-3.0, 3.0, 3.0, 3.0, 3.0, 3.0, 3.0}).size(), 1U);
    }

    void farBeyondTwoSamplesAreEnough()
    {
        Crossing crossing;
        QVERIFY(passagesOf(crossing, {-3.0, 9.0, -3.0, -3.0}).empty());
        QCOMPARE(passagesOf(crossing, {-3.0, 9.0, 9.0}).size(), 1U);
    }

    void latestWayThroughCounts()
    {
        Crossing crossing;
        const auto found = passagesOf(crossing, {-1.0, 1.0, -1.0, 1.0, 9.0, 9.0});
        QCOMPARE(found.size(), 1U);
        QVERIFY(std::abs(secondsOf(found.front()) - 0.05) < kExact);
    }

    void passageInAGapIsUnseen()
    {
        Crossing crossing;
        (void)crossing.take(-9.0, at(0), kRule);
        (void)crossing.take(9.0, at(400), kRule);
        const auto passage = crossing.take(9.0, at(420), kRule);
        QVERIFY(passage && passage->wasUnseen);
        QVERIFY(std::abs(secondsOf(*passage) - 0.2) < kExact);
    }

    void whatIsInAtFirstWasNotSeenToComeIn()
    {
        Crossing crossing;
        const auto found = passagesOf(crossing, {9.0, 9.0});
        QVERIFY(found.size() == 1 && found.front().wasUnseen);
        QVERIFY(std::abs(secondsOf(found.front())) < kExact);
    }

    void whatIsKeptInGoesOutAfterItsTimeOnly()
    {
        CrossingRule rule = kRule;
        rule.keepsIn = true;
        Crossing crossing;
        std::vector<double> values{-9.0, 9.0, 9.0};
        values.insert(values.end(), 15, -9.0); // 280 ms
        QCOMPARE(passagesOf(crossing, values, rule).size(), 1U);
        const auto out = crossing.take(-9.0, at(360), rule);
        QVERIFY(out && !out->isIn && std::abs(secondsOf(*out) - 0.05) < kExact);
    }
};

CARINA_TEST(TestCrossing)

} // namespace carina::crossing_test

#include "tst_crossing.moc"
