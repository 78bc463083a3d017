#include "engine/tracking/simulated/simulated_tracker.h"
#include "tests/support/test_class.h"

#include <array>
#include <cstdlib>

namespace carina::simulated_tracker_test
{
namespace
{

using namespace std::chrono_literals;

SessionTime at(Duration t) { return SessionTime{t}; }

const RigidTransform kX_TO{Quat{0.5, 0.5, -0.5, 0.5}, Vec3{0.1, -0.2, -1.0}};

std::optional<RigidTransform> resting(ToolRole, SessionTime) { return kX_TO; }

std::optional<SessionTime> noClock() { return std::nullopt; }

SimulatedTrackerSettings prompt()
{
    SimulatedTrackerSettings settings;
    settings.latency = Duration::zero();
    return settings;
}

PoseHistory& historyOf(SimulatedTracker& tracker, ToolRole role)
{
    for (const TrackedTool& tool : tracker.tools()) {
        if (tool.role == role)
            return *tool.history;
    }
    std::abort();
}

std::vector<PoseSample> tubeSamples(SimulatedTracker& tracker)
{
    return historyOf(tracker, ToolRole::Tube).samples();
}

} // namespace

/// The simulated tracker in virtual time, without its thread.
class SimulatedTrackerTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void hasHeadJawTubeAndStylus()
    {
        const SimulatedTracker tracker{{}, resting, noClock};
        const std::vector<TrackedTool> tools = tracker.tools();
        QCOMPARE(tools.size(), std::size_t{4});
        const std::array<std::pair<std::string, ToolRole>, 4> expected{
            {{"head", ToolRole::Head},
             {"jaw", ToolRole::Jaw},
             {"tube", ToolRole::Tube},
             {"stylus", ToolRole::Stylus}}};
        for (std::size_t i = 0; i < 4; ++i) {
            QCOMPARE(tools[i].name, expected[i].first);
            QCOMPARE(tools[i].role, expected[i].second);
            QVERIFY(tools[i].history != nullptr);
        }
    }

    void exposesAtItsRate_data()
    {
        QTest::addColumn<double>("rateHz");
        QTest::addColumn<std::size_t>("samples");
        QTest::newRow("60 Hz") << 60.0 << std::size_t{121};
        QTest::newRow("30 Hz") << 30.0 << std::size_t{61};
    }
    void exposesAtItsRate()
    {
        QFETCH(double, rateHz);
        QFETCH(std::size_t, samples);
        SimulatedTrackerSettings settings = prompt();
        settings.rate = hertz(rateHz);
        SimulatedTracker tracker{settings, resting, noClock};
        const SessionTime start = at(5s);
        for (SessionTime now = start; now <= start + 2s;) {
            const SessionTime due = tracker.advance(now);
            QVERIFY(due > now);
            now = due;
        }
        const std::vector<PoseSample> taken = tubeSamples(tracker);
        QCOMPARE(taken.size(), samples);
        for (std::size_t i = 0; i < taken.size(); ++i)
            QCOMPARE(taken[i].time, start + fromSeconds(static_cast<double>(i) / rateHz));
    }

    void stampsAtExposureAndDeliversALatencyLater()
    {
        SimulatedTrackerSettings settings;
        settings.latency = 14ms;
        SimulatedTracker tracker{settings, resting, noClock};
        QCOMPARE(tracker.advance(at(1s)), at(1s + 14ms));
        QCOMPARE(tracker.advance(at(1s + 14ms - 1ns)), at(1s + 14ms));
        QVERIFY(tubeSamples(tracker).empty());
        QCOMPARE(tracker.advance(at(1s + 14ms)), at(1s) + fromSeconds(1.0 / 60.0));
        QCOMPARE(tubeSamples(tracker).size(), std::size_t{1});
        QCOMPARE(tubeSamples(tracker).front().time, at(1s));
    }

    void deliversInOrderWhenTheLatencySpansSeveralTicks()
    {
        SimulatedTrackerSettings settings;
        settings.latency = 40ms;
        SimulatedTracker tracker{settings, resting, noClock};
        for (SessionTime now = at(0s); now < at(90ms);)
            now = tracker.advance(now);
        QCOMPARE(tubeSamples(tracker).size(), std::size_t{3}); // of 0, 16.7 and 33.3 ms
    }

    void catchesUpWithinASecondAndStartsAnewBeyond_data()
    {
        QTest::addColumn<qint64>("after");
        QTest::addColumn<std::size_t>("samples");
        const qint64 tick = fromSeconds(1.0 / 60.0).count();
        QTest::newRow("a second late") << tick + 1'000'000'000 << std::size_t{62};
        QTest::newRow("a nanosecond more") << tick + 1'000'000'001 << std::size_t{2};
        QTest::newRow("half a second early") << tick - 500'000'000 << std::size_t{1};
        QTest::newRow("a second early") << tick - 1'000'000'000 << std::size_t{1};
        QTest::newRow("and a nanosecond more") << tick - 1'000'000'001 << std::size_t{2};
    }
    void catchesUpWithinASecondAndStartsAnewBeyond()
    {
        QFETCH(qint64, after);
        QFETCH(std::size_t, samples);
        SimulatedTracker tracker{prompt(), resting, noClock};
        tracker.advance(at(20s));
        tracker.advance(at(20s) + Duration{after});
        QCOMPARE(tubeSamples(tracker).size(), samples);
    }

    void forgetsWhatIsUnderwayWhenTheClockIsSetBack()
    {
        SimulatedTracker tracker{{}, resting, noClock};
        tracker.advance(at(20s));
        tracker.advance(at(10s));
        tracker.advance(at(10s + 14ms));
        QCOMPARE(tubeSamples(tracker).size(), std::size_t{1});
        QCOMPARE(tubeSamples(tracker).front().time, at(10s));
    }

    void losesAToolWhileItIsHiddenByScript()
    {
        SimulatedTrackerSettings settings = prompt();
        settings.rate = hertz(10.0);
        settings.occlusions = {{ToolRole::Tube, at(200ms), at(400ms)}};
        SimulatedTracker tracker{settings, resting, noClock};
        tracker.advance(at(0s));
        tracker.advance(at(500ms));
        const std::vector<PoseSample> taken = tubeSamples(tracker);
        QCOMPARE(taken.size(), std::size_t{6});
        for (std::size_t i = 0; i < taken.size(); ++i)
            QCOMPARE(taken[i].validity, i == 2 || i == 3 ? Validity::Lost : Validity::Tracked);
        QCOMPARE(taken[2].X_FO.translation(), taken[1].X_FO.translation());
        QCOMPARE(taken[3].X_FO.translation(), taken[1].X_FO.translation());
        QCOMPARE(taken[2].error, 0.0);
        QVERIFY(taken[4].X_FO.translation() != taken[1].X_FO.translation());
        for (const PoseSample& sample : historyOf(tracker, ToolRole::Head).samples())
            QCOMPARE(sample.validity, Validity::Tracked);
    }

    void losesAToolOutsideTheWorkingVolume()
    {
        const auto leaving = [](ToolRole, SessionTime t) -> std::optional<RigidTransform> {
            const double x = t < at(1s) ? 0.0 : 0.4;
            return RigidTransform::translation({x, 0.0, -1.0});
        };
        SimulatedTracker tracker{prompt(), leaving, noClock};
        tracker.advance(at(990ms));
        tracker.advance(at(1010ms));
        const std::vector<PoseSample> taken = tubeSamples(tracker);
        QCOMPARE(taken.size(), std::size_t{2});
        QCOMPARE(taken[1].validity, Validity::Lost);
        QCOMPARE(taken[1].X_FO.translation(), taken[0].X_FO.translation());
    }

    /// A flat probe, whose markers face +z of O, is turned over after a second.
    void measuresTheMarkersOfAnotherProbe()
    {
        const auto turning = [](ToolRole, SessionTime t) -> std::optional<RigidTransform> {
            const Quat q_TO = t < at(1s) ? Quat::Identity() : Quat{0.0, 1.0, 0.0, 0.0};
            return RigidTransform{q_TO, Vec3{0.0, 0.0, -1.0}};
        };
        SimulatedTrackerSettings settings = prompt();
        settings.probes[ToolRole::Tube] = {.markers = {{{0.0, 0.0, 0.0}, Vec3::UnitZ()},
                                                       {{0.05, 0.0, 0.0}, Vec3::UnitZ()},
                                                       {{0.0, 0.08, 0.0}, Vec3::UnitZ()},
                                                       {{-0.04, -0.06, 0.0}, Vec3::UnitZ()}}};
        SimulatedTracker tracker{settings, turning, noClock};
        for (const TrackedTool& tool : tracker.tools())
            QCOMPARE(tool.probe->markers.size() == 4, tool.role == ToolRole::Tube);
        tracker.advance(at(990ms));
        tracker.advance(at(1010ms));
        const std::vector<PoseSample> taken = tubeSamples(tracker);
        QCOMPARE(taken.size(), std::size_t{2});
        QCOMPARE(taken[0].validity, Validity::Tracked);
        QVERIFY((taken[0].X_FO.translation() - Vec3{0.0, 0.0, -1.0}).norm() < 0.001);
        QCOMPARE(taken[1].validity, Validity::Lost);
        for (const PoseSample& sample : historyOf(tracker, ToolRole::Head).samples())
            QCOMPARE(sample.validity, Validity::Tracked);
    }

    void losesAToolThatSomethingHidesAndKnowsNoneNeverSeen()
    {
        const auto hidden = [](ToolRole role, SessionTime t) -> std::optional<RigidTransform> {
            if (role == ToolRole::Jaw || t >= at(100ms))
                return std::nullopt;
            return kX_TO;
        };
        SimulatedTracker tracker{prompt(), hidden, noClock};
        tracker.advance(at(90ms));
        tracker.advance(at(110ms));
        QVERIFY(historyOf(tracker, ToolRole::Jaw).samples().empty());
        QCOMPARE(tubeSamples(tracker).back().validity, Validity::Lost);
    }

    void repeatsItselfFromTheSameSeed()
    {
        const auto positionsFrom = [](std::uint32_t seed) {
            SimulatedTrackerSettings settings = prompt();
            settings.seed = seed;
            SimulatedTracker tracker{settings, resting, noClock};
            tracker.advance(at(0s));
            tracker.advance(at(1s));
            std::vector<double> x;
            for (const PoseSample& sample : tubeSamples(tracker))
                x.push_back(sample.X_FO.translation().x());
            return x;
        };
        QCOMPARE(positionsFrom(7), positionsFrom(7));
        QVERIFY(positionsFrom(7) != positionsFrom(8));
    }
};

CARINA_TEST(SimulatedTrackerTest)

} // namespace carina::simulated_tracker_test

#include "tst_simulated_tracker.moc"
