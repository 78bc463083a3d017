#include "evaluation/network/drift_scenario.h"
#include "tests/support/test_class.h"

#include <QTemporaryDir>

#include <fstream>

namespace carina::drift_scenario_test
{
namespace
{

using namespace std::chrono_literals;

std::string written(const QTemporaryDir& folder, const QByteArray& text)
{
    const std::string path = folder.filePath(QStringLiteral("trace.txt")).toStdString();
    std::ofstream{path} << text.toStdString();
    return path;
}

} // namespace

class DriftScenarioTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyNameIsFound()
    {
        QCOMPARE(scenarioNames().size(), 16U);
        for (const std::string_view name : scenarioNames())
            QCOMPARE(findScenario(std::string{name})->name, std::string{name});
    }

    void delaysAreThoseAsked_data()
    {
        QTest::addColumn<QByteArray>("name");
        QTest::addColumn<double>("forward_ms");
        QTest::addColumn<double>("backward_ms");
        QTest::addColumn<double>("loss");
        // Constant delay, and the queue's mean.
        QTest::newRow("lan") << QByteArray{"lan"} << 0.2 << 0.2 << 0.0;
        QTest::newRow("wifi") << QByteArray{"wifi"} << 5.0 << 5.0 << 0.005;
        QTest::newRow("metro") << QByteArray{"metro"} << 8.5 << 8.5 << 0.0;
        QTest::newRow("wan") << QByteArray{"wan"} << 42.0 << 42.0 << 0.005;
        QTest::newRow("asymmetric") << QByteArray{"asymmetric"} << 27.0 << 57.0 << 0.0;
        QTest::newRow("cellular") << QByteArray{"cellular"} << 39.0 << 24.0 << 0.02;
        QTest::newRow("starlink") << QByteArray{"starlink"} << 24.82 << 24.82 << 0.0;
    }
    void delaysAreThoseAsked()
    {
        QFETCH(QByteArray, name);
        QFETCH(double, forward_ms);
        QFETCH(double, backward_ms);
        QFETCH(double, loss);
        const DriftScenario scenario = *findScenario(name.toStdString());
        const auto mean_ms = [](const PathProfile& path) {
            const double share = path.jitter == PathProfile::Jitter::Pareto ? 0.5 : 1.0;
            return toSeconds(path.delay) * 1e3 + share * toSeconds(path.jitterScale) * 1e3;
        };
        QVERIFY(std::abs(mean_ms(scenario.forward) - forward_ms) < 1e-9);
        QVERIFY(std::abs(mean_ms(scenario.backward) - backward_ms) < 1e-9);
        QCOMPARE(scenario.forward.loss, loss);
    }

    void quantilesAreThoseMeasured_data()
    {
        QTest::addColumn<QByteArray>("name");
        QTest::addColumn<bool>("isForward");
        QTest::addColumn<double>("median_ms");
        QTest::addColumn<double>("p99_ms");
        QTest::newRow("5g up") << QByteArray{"5g"} << true << 6.4 << 10.9;
        QTest::newRow("5g down") << QByteArray{"5g"} << false << 5.3 << 10.9;
        QTest::newRow("starlink") << QByteArray{"starlink"} << true << 22.0 << 58.0;
    }
    void quantilesAreThoseMeasured()
    {
        QFETCH(QByteArray, name);
        QFETCH(bool, isForward);
        QFETCH(double, median_ms);
        QFETCH(double, p99_ms);
        const DriftScenario scenario = *findScenario(name.toStdString());
        const PathProfile& path = isForward ? scenario.forward : scenario.backward;
        const auto quantile_ms = [&](double share) {
            return 1e3 * (toSeconds(path.delay) - toSeconds(path.jitterScale) * std::log1p(-share));
        };
        QVERIFY(std::abs(quantile_ms(0.5) - median_ms) < 0.05);
        QVERIFY(std::abs(quantile_ms(0.99) - p99_ms) < 0.05);
    }

    void oneThingGoesWrongAtATime()
    {
        QCOMPARE(findScenario("step")->forward.stepAt, Duration{30s});
        QCOMPARE(findScenario("step")->backward.stepBy, Duration{20ms});
        QCOMPARE(findScenario("partition")->forward.cutFor, Duration{2s});
        QCOMPARE(findScenario("burst")->forward.burst->enter, 0.01);
        QCOMPARE(findScenario("burst")->forward.burst->leave, 0.25);
        QCOMPARE(findScenario("bottleneck")->backward.bitsPerSecond, 1e6);
        QVERIFY(findScenario("duplication")->forward.duplication > 0.0);
        QVERIFY(findScenario("reordering")->forward.reordering > 0.0);
        QCOMPARE(findScenario("clock")->clockOffset, Duration{250ms});
        QCOMPARE(findScenario("clock")->clockSkew, 50e-6);
        QVERIFY(findScenario("clock")->areClocksAtLimits);
    }

    void paperHasSlowSoftwareAndFrames()
    {
        const DriftScenario paper = *findScenario("paper");
        QCOMPARE(paper.forward.delay, Duration{95ms});
        QCOMPARE(paper.backward.delay, Duration{95ms});
        QCOMPARE(paper.frames.rate, 35.0);
        // A message waits for up to one frame.
        QVERIFY(std::abs(2.0 * toSeconds(paper.forward.jitterScale) - 1.0 / 35.0) < 1e-8);
        QCOMPARE(findScenario("metro")->frames.rate, 0.0);
    }

    void displaysRunByThemselves()
    {
        constexpr ViewFrames kFrames{.rate = 35.0, .rateError = 0.01};
        const auto displays = displaysOf(kFrames, 100, 3);
        QCOMPARE(displays.size(), std::size_t{100});
        double phases = 0.0;
        for (const DisplayFrames& display : displays) {
            const double rate = 1.0 / toSeconds(display.interval);
            QVERIFY(std::abs(rate - 35.0) <= 0.35 + 1e-6);
            const double phase = -toSeconds(display.first) * rate;
            QVERIFY(phase >= 0.0 && phase < 1.0 + 1e-6);
            phases += phase / 100.0;
        }
        QVERIFY(std::abs(phases - 0.5) < 0.1); // even: three of its standard errors
        QCOMPARE(displaysOf(kFrames, 1, 3)[0].first, displays[0].first);
        QVERIFY(displaysOf(kFrames, 1, 4)[0].first != displays[0].first);
        QCOMPARE(displaysOf({}, 2, 3)[1].interval, Duration{});
    }

    void readsATrace()
    {
        const QTemporaryDir folder;
        const auto scenario =
            findScenario(written(folder, "# measured\n0 10.5\n\n 20.25 x # lost\n40 12\n"));
        QVERIFY(scenario);
        const auto& points = *scenario->forward.trace;
        QCOMPARE(points.size(), 3U);
        QCOMPARE(points[0].at, Duration{});
        QCOMPARE(points[0].delay, std::optional{Duration{10500us}});
        QCOMPARE(points[1].at, Duration{20250us});
        QVERIFY(!points[1].delay);
        QCOMPARE(scenario->backward.trace->at(2).delay, std::optional{Duration{12ms}});
        QCOMPARE(scenario->forward.delay, Duration{});
    }

    void refusesABadTrace_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<int>("code");
        const int malformed = int(Errc::FileMalformed);
        QTest::newRow("empty") << QByteArray{""} << int(Errc::FileEmpty);
        QTest::newRow("only a comment") << QByteArray{"# 0 10\n"} << int(Errc::FileEmpty);
        QTest::newRow("one number") << QByteArray{"0 1\n10\n"} << malformed;
        QTest::newRow("three numbers") << QByteArray{"0 1\n10 2 3\n"} << malformed;
        QTest::newRow("no number") << QByteArray{"0 1\n10 fast\n"} << malformed;
        QTest::newRow("half a number") << QByteArray{"0 1\n10 2ms\n"} << malformed;
        QTest::newRow("negative delay") << QByteArray{"0 1\n10 -2\n"} << malformed;
        QTest::newRow("endless delay") << QByteArray{"0 1\n10 inf\n"} << malformed;
        QTest::newRow("no time") << QByteArray{"0 1\nnan 2\n"} << malformed;
        QTest::newRow("the same time") << QByteArray{"0 1\n0 2\n"} << malformed;
        QTest::newRow("an earlier time") << QByteArray{"0 1\n-1 2\n"} << malformed;
    }
    void refusesABadTrace()
    {
        QFETCH(QByteArray, text);
        QFETCH(int, code);
        const QTemporaryDir folder;
        const auto scenario = findScenario(written(folder, text));
        QVERIFY(!scenario);
        QCOMPARE(int(scenario.error().code), code);
        if (code == int(Errc::FileMalformed))
            QVERIFY(scenario.error().detail.find("line 2:") != std::string::npos);
    }

    void refusesWhatIsNeitherNameNorFile()
    {
        const auto scenario = findScenario("no such thing");
        QVERIFY(!scenario);
        QCOMPARE(scenario.error().code, Errc::FileNotFound);
        QVERIFY(scenario.error().detail.starts_with(
            "no such thing is neither a trace file nor one of the scenarios "));
        for (const std::string_view name : scenarioNames())
            QVERIFY(scenario.error().detail.find(name) != std::string::npos);
    }
};

CARINA_TEST(DriftScenarioTest)

} // namespace carina::drift_scenario_test

#include "tst_drift_scenario.moc"
