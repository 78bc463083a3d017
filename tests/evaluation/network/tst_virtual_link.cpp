#include "evaluation/network/virtual_link.h"
#include "tests/support/test_class.h"

#include <cmath>

namespace carina::virtual_link_test
{
namespace
{

using namespace std::chrono_literals;

constexpr std::size_t kBytes = 100;
constexpr int kMany = 40000;

/// What happened to datagrams sent every 10 ms.
struct Fates {
    double lost = 0.0;
    double twice = 0.0;
    double meanDelay = 0.0; ///< seconds, of those that arrived
    double variance = 0.0;  ///< of the same
};

Fates fatesOf(const PathProfile& path, std::uint64_t seed = 1)
{
    VirtualLink link{path, seed};
    Fates fates;
    double sum = 0.0;
    double squares = 0.0;
    int arrived = 0;
    for (int i = 0; i < kMany; ++i) {
        const Duration now = i * 10ms;
        const auto arrivals = link.send(kBytes, now);
        fates.lost += arrivals.count == 0 ? 1.0 / kMany : 0.0;
        fates.twice += arrivals.count == 2 ? 1.0 / kMany : 0.0;
        if (arrivals.count == 0)
            continue;
        const double delay = toSeconds(arrivals.at[0] - now);
        ++arrived;
        sum += delay;
        squares += delay * delay;
    }
    fates.meanDelay = sum / arrived;
    fates.variance = squares / arrived - fates.meanDelay * fates.meanDelay;
    return fates;
}

/// A share of kMany lies this close to its probability, four standard deviations.
bool isShare(double share, double probability)
{
    return std::abs(share - probability)
           <= 4.0 * std::sqrt(probability * (1.0 - probability) / kMany);
}

Duration delayOfOne(const PathProfile& path, Duration now)
{
    VirtualLink link{path, 1};
    const auto arrivals = link.send(kBytes, now);
    return arrivals.count == 0 ? Duration{-1} : arrivals.at[0] - now;
}

} // namespace

class VirtualLinkTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void delaysEachDatagramAlike()
    {
        const Fates fates = fatesOf({.delay = 7ms});
        QCOMPARE(fates.lost, 0.0);
        QCOMPARE(fates.twice, 0.0);
        QCOMPARE(delayOfOne({.delay = 7ms}, 3s), Duration{7ms});
    }

    void queuesHaveTheirMeanAndVariance_data()
    {
        QTest::addColumn<int>("jitter");
        QTest::addColumn<double>("mean_s");
        QTest::addColumn<double>("variance_s2");
        // Exponential of mean 3 ms; Pareto II of scale 6 ms and shape 3, mean 6/2 ms, variance
        // 36 * 3 / (4 * 1) ms^2, of which so many draws leave a good part to chance.
        QTest::newRow("exponential") << int(PathProfile::Jitter::Exponential) << 3e-3 << 9e-6;
        QTest::newRow("Pareto") << int(PathProfile::Jitter::Pareto) << 3e-3 << 27e-6;
        // Between -6 and 6 ms: (12 ms)^2 / 12.
        QTest::newRow("uniform") << int(PathProfile::Jitter::Uniform) << 0.0 << 12e-6;
    }
    void queuesHaveTheirMeanAndVariance()
    {
        QFETCH(int, jitter);
        QFETCH(double, mean_s);
        QFETCH(double, variance_s2);
        const bool isExponential = jitter == int(PathProfile::Jitter::Exponential);
        const bool isPareto = jitter == int(PathProfile::Jitter::Pareto);
        const Fates fates = fatesOf({.delay = 20ms,
                                     .jitter = static_cast<PathProfile::Jitter>(jitter),
                                     .jitterScale = isExponential ? 3ms : 6ms});
        QVERIFY(std::abs(fates.meanDelay - 20e-3 - mean_s) < 4.0 * std::sqrt(variance_s2 / kMany));
        QVERIFY(std::abs(fates.variance / variance_s2 - 1.0) < (isPareto ? 0.4 : 0.06));
    }

    void losesAndDuplicatesItsShare()
    {
        const Fates fates = fatesOf({.delay = 2ms, .loss = 0.02, .duplication = 0.1});
        QVERIFY(isShare(fates.lost, 0.02));
        QVERIFY(isShare(fates.twice, 0.98 * 0.1));
    }

    void holdsUpItsShare()
    {
        const Fates fates = fatesOf({.delay = 2ms, .reordering = 0.05, .heldUp = 20ms});
        QVERIFY(std::abs(fates.meanDelay - (2e-3 + 0.05 * 20e-3)) < 1e-4);
    }

    void losesInBursts()
    {
        // In the long run 1/(1 + 25) of the time is bad, and a bad time lasts 4 datagrams.
        PathProfile path{.delay = 2ms};
        path.burst = {0.01, 0.25};
        VirtualLink link{path, 3};
        int lost = 0;
        int bursts = 0;
        bool wasLost = false;
        for (int i = 0; i < kMany; ++i) {
            const bool isLost = link.send(kBytes, i * 10ms).count == 0;
            lost += isLost ? 1 : 0;
            bursts += isLost && !wasLost ? 1 : 0;
            wasLost = isLost;
        }
        QVERIFY(std::abs(double(lost) / kMany - 1.0 / 26.0) < 0.006);
        QVERIFY(std::abs(double(lost) / bursts - 4.0) < 0.5);
    }

    void anOracleSeesWhatTheFirstDatagramOfAnInstantMeets()
    {
        PathProfile path{.delay = 2ms,
                         .jitter = PathProfile::Jitter::Exponential,
                         .jitterScale = 3ms,
                         .loss = 0.2};
        path.burst = {0.01, 0.25};
        VirtualLink asked{path, 5};
        VirtualLink used{path, 5};
        VirtualLink other{path, 6};
        int differs = 0;
        for (int i = 0; i < 1000; ++i) {
            const Duration now = -3s + i * 7ms;
            const auto delay = asked.delayAt(now);
            const auto arrivals = used.send(kBytes, now);
            QCOMPARE(arrivals.count, delay ? 1U : 0U);
            if (delay)
                QCOMPARE(arrivals.at[0], now + *delay);
            differs += other.delayAt(now) != delay ? 1 : 0;
        }
        QVERIFY(differs > 500);
    }

    void datagramsOfOneInstantDrawEachForThemselves()
    {
        VirtualLink link{
            {.delay = 2ms, .jitter = PathProfile::Jitter::Exponential, .jitterScale = 3ms}, 1};
        const Duration first = link.send(kBytes, 1s).at[0];
        QVERIFY(link.send(kBytes, 1s).at[0] != first);
    }

    void bottleneckSendsOneAfterTheOther()
    {
        // 972 bytes and 28 of headers are 8000 bits: 8 ms at 1 Mbit/s.
        VirtualLink link{{.delay = 5ms, .bitsPerSecond = 1e6, .queueBytes = 2000}, 1};
        QCOMPARE(link.send(972, 1s).at[0], Duration{1s + 13ms});
        QCOMPARE(link.send(972, 1s).at[0], Duration{1s + 21ms});
        QCOMPARE(link.send(972, 1s + 1ms).at[0], Duration{1s + 29ms});
        // 24 ms are taken, of which 16 may be queued.
        QCOMPARE(link.send(972, 1s + 8ms - 1ns).count, 0U);
        QCOMPARE(link.send(972, 1s + 8ms).at[0], Duration{1s + 37ms});
        QCOMPARE(link.send(972, 2s).at[0], Duration{2s + 13ms});
    }

    void stepsAndCutsWhenTold()
    {
        const PathProfile path{
            .delay = 8ms, .stepAt = 30s, .stepBy = 20ms, .cutFrom = 40s, .cutFor = 2s};
        QCOMPARE(delayOfOne(path, 30s - 1ns), Duration{8ms});
        QCOMPARE(delayOfOne(path, 30s), Duration{28ms});
        QCOMPARE(delayOfOne(path, 40s - 1ns), Duration{28ms});
        QCOMPARE(delayOfOne(path, 40s), Duration{-1});
        QCOMPARE(delayOfOne(path, 42s - 1ns), Duration{-1});
        QCOMPARE(delayOfOne(path, 42s), Duration{28ms});
    }

    void followsATraceAgainAndAgain()
    {
        PathProfile path;
        path.trace = std::make_shared<const std::vector<TracePoint>>(std::vector<TracePoint>{
            {0ms, Duration{10ms}}, {100ms, std::nullopt}, {199ms, Duration{30ms}}});
        QCOMPARE(delayOfOne(path, 0ms), Duration{10ms});
        QCOMPARE(delayOfOne(path, 100ms - 1ns), Duration{10ms});
        QCOMPARE(delayOfOne(path, 100ms), Duration{-1});
        // The last holds as long as the one before it.
        QCOMPARE(delayOfOne(path, 199ms), Duration{30ms});
        QCOMPARE(delayOfOne(path, 298ms - 1ns), Duration{30ms});
        QCOMPARE(delayOfOne(path, 298ms), Duration{10ms});
        QCOMPARE(delayOfOne(path, 298ms + 199ms), Duration{30ms});
        QCOMPARE(delayOfOne(path, -1ns), Duration{30ms});
    }

    void twoHalvesAreTheWhole()
    {
        PathProfile path{.delay = 40ms,
                         .jitter = PathProfile::Jitter::Exponential,
                         .jitterScale = 2ms,
                         .loss = 0.19,
                         .duplication = 0.36,
                         .reordering = 0.51,
                         .heldUp = 20ms,
                         .stepAt = 30s,
                         .stepBy = 20ms};
        path.burst = {0.01, 0.25};
        path.trace = std::make_shared<const std::vector<TracePoint>>(
            std::vector<TracePoint>{{0ms, Duration{10ms}}, {1ms, std::nullopt}});
        const PathProfile leg = halfOf(path);
        QCOMPARE(leg.delay, Duration{20ms});
        QCOMPARE(leg.jitterScale, Duration{1ms});
        QVERIFY(std::abs(leg.loss - 0.1) < 1e-12);
        QVERIFY(std::abs(leg.duplication - 0.2) < 1e-12);
        QVERIFY(std::abs(leg.reordering - 0.3) < 1e-12);
        QCOMPARE(leg.heldUp, Duration{20ms});
        QCOMPARE(leg.stepBy, Duration{10ms});
        QCOMPARE(leg.burst->enter, 0.005);
        QCOMPARE(leg.burst->leave, 0.25);
        QCOMPARE(leg.trace->at(0).delay, std::optional{Duration{5ms}});
        QVERIFY(!leg.trace->at(1).delay);
        QCOMPARE(path.trace->at(0).delay, std::optional{Duration{10ms}});
    }
};

CARINA_TEST(VirtualLinkTest)

} // namespace carina::virtual_link_test

#include "tst_virtual_link.moc"
