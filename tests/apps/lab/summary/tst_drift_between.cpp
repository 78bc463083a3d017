#include "apps/lab/summary/drift_between.h"

#include "engine/geometry/rotation.h"
#include "tests/support/test_class.h"

#include <utility>
#include <vector>

namespace carina::drift_between_test
{

using carina::lab::driftBetween;
using carina::lab::DriftSummary;

namespace
{

constexpr double kDegreesPerSecond = 100.0;
constexpr double kMillimetresPerSecond = 200.0;

/// Frames of a tube that turns and moves steadily, at 60 Hz from `start`, told `late` behind.
std::vector<LoggedFrame> steady(Duration start, Duration late, Duration clockOffset = {})
{
    std::vector<LoggedFrame> frames;
    for (int i = 0; i < 120; ++i) {
        LoggedFrame frame;
        const Duration local = start + Duration{i * 16'666'667LL};
        frame.local = LocalTime{local};
        frame.session = SessionTime{local + clockOffset};
        const double t = toSeconds(local - late);
        frame.X_AE =
            RigidTransform{rotationFromVector(Vec3{0.0, 0.0, degrees(kDegreesPerSecond * t).si}),
                           Vec3{millimetres(kMillimetresPerSecond * t).si, 0.0, 0.0}};
        frames.push_back(frame);
    }
    return frames;
}

constexpr double kTolerance_deg = 1e-6;
constexpr double kTolerance_mm = 1e-6;

} // namespace

class TestDriftBetween : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void seesNoDriftBetweenFramesOfOneMotion()
    {
        using std::chrono::milliseconds;
        const DriftSummary drift = driftBetween(steady({}, {}), steady(milliseconds{7}, {}));
        QVERIFY(drift.instants > 110);
        QVERIFY(drift.largest_deg < kTolerance_deg);
        QVERIFY(drift.largest_mm < kTolerance_mm);
        QCOMPARE(drift.clockLargest_ms, 0.0);
    }

    void lagIsVelocityTimesDelay()
    {
        using std::chrono::milliseconds;
        const DriftSummary drift =
            driftBetween(steady({}, {}), steady(milliseconds{7}, milliseconds{28}));
        // 100 deg/s x 28 ms, the arithmetic of the published 2.83 deg.
        QVERIFY(std::abs(drift.mean_deg - 2.8) < kTolerance_deg);
        QVERIFY(std::abs(drift.mean_mm - 5.6) < kTolerance_mm);
        QVERIFY(std::abs(drift.p95_deg - 2.8) < kTolerance_deg);
    }

    void comparesWhicheverPoseItIsTold()
    {
        using std::chrono::milliseconds;
        auto owner = steady({}, {});
        auto viewer = steady(milliseconds{7}, milliseconds{28});
        for (auto* frames : {&owner, &viewer})
            for (LoggedFrame& frame : *frames)
                frame.X_AV = std::exchange(frame.X_AE, std::nullopt);
        QCOMPARE(driftBetween(owner, viewer).instants, 0);
        const DriftSummary drift = driftBetween(owner, viewer, &LoggedFrame::X_AV);
        QVERIFY(std::abs(drift.mean_deg - 2.8) < kTolerance_deg);
    }

    void clocksAreHeldAgainstTheSharedLocalClock()
    {
        using std::chrono::milliseconds;
        const DriftSummary drift =
            driftBetween(steady({}, {}), steady(milliseconds{7}, {}, milliseconds{5}));
        constexpr double kTolerance_ms = 1e-4; // a frame period is rounded to whole nanoseconds
        QVERIFY(std::abs(drift.clockMean_ms - 5.0) < kTolerance_ms);
        QVERIFY(std::abs(drift.clockLargest_ms - 5.0) < kTolerance_ms);
    }

    void framesThatDoNotOverlapAreNotCompared()
    {
        using std::chrono::seconds;
        QCOMPARE(driftBetween(steady({}, {}), steady(seconds{60}, {})).instants, 0);
        QCOMPARE(driftBetween({}, {}).instants, 0);
    }
};

CARINA_TEST(TestDriftBetween)

} // namespace carina::drift_between_test

#include "tst_drift_between.moc"
