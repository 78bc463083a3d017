#include "engine/tracking/record/recorded_tracker.h"
#include "tests/support/test_class.h"

#include <latch>

namespace carina::recorded_tracker_test
{
namespace
{

using namespace std::chrono_literals;

SessionTime at(Duration t) { return SessionTime{t}; }

std::optional<SessionTime> noClock() { return std::nullopt; }

RecordedTool toolWith(const std::string& name, ToolRole role, std::vector<Duration> times)
{
    RecordedTool tool{.name = name, .role = role};
    for (const Duration t : times)
        tool.samples.push_back({.time = at(t), .X_FO = RigidTransform::translation({1, 2, 3})});
    return tool;
}

/// Two tools, from 100 s on the clock of their file.
TrackerSequence twoTools()
{
    return {{toolWith("Stylus", ToolRole::Stylus, {100s, 100'100ms, 100'200ms}),
             toolWith("Reference", ToolRole::Other, {100'050ms, 100'150ms})}};
}

std::vector<SessionTime> timesOf(const TrackedTool& tool)
{
    std::vector<SessionTime> times;
    for (const PoseSample& sample : tool.history->samples())
        times.push_back(sample.time);
    return times;
}

} // namespace

class RecordedTrackerTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void hasTheToolsOfTheRecording()
    {
        const RecordedTracker tracker{twoTools(), noClock};
        QCOMPARE(tracker.tools().size(), std::size_t{2});
        QCOMPARE(tracker.tools()[0].name, std::string{"Stylus"});
        QCOMPARE(tracker.tools()[0].role, ToolRole::Stylus);
        QCOMPARE(tracker.tools()[1].name, std::string{"Reference"});
    }

    void playsAtThePaceOfTheRecording()
    {
        RecordedTracker tracker{twoTools(), noClock};
        const SessionTime start = at(7s);
        QCOMPARE(tracker.advance(start).value(), start + 50ms);
        QCOMPARE(timesOf(tracker.tools()[0]), std::vector{start});
        QVERIFY(timesOf(tracker.tools()[1]).empty());
        QCOMPARE(tracker.advance(start + 50ms - 1ns).value(), start + 50ms);
        QVERIFY(timesOf(tracker.tools()[1]).empty());
        QCOMPARE(tracker.advance(start + 50ms).value(), start + 100ms);
        QCOMPARE(timesOf(tracker.tools()[1]), std::vector{start + 50ms});
        QVERIFY(!tracker.advance(start + 200ms));
        QCOMPARE(timesOf(tracker.tools()[0]), (std::vector{start, start + 100ms, start + 200ms}));
        QCOMPARE(timesOf(tracker.tools()[1]), (std::vector{start + 50ms, start + 150ms}));
        QCOMPARE(tracker.tools()[0].history->newest()->X_FO.translation(), Vec3(1, 2, 3));
    }

    void beginsAgainAfterAPauseThatIsNotInterpolated()
    {
        RecordedTracker tracker{twoTools(), noClock, Playing::Looped};
        const SessionTime start = at(7s);
        tracker.advance(start);
        const SessionTime again = start + 200ms + RecordedTracker::kPause;
        QCOMPARE(tracker.advance(start + 200ms).value(), again);
        QCOMPARE(tracker.advance(again + 100ms).value(), again + 150ms);
        const TrackedTool stylus = tracker.tools()[0];
        QCOMPARE(timesOf(stylus),
                 (std::vector{start, start + 100ms, start + 200ms, again, again + 100ms}));
        QCOMPARE(stylus.history->at(again - 100ms)->validity, Validity::Lost);
        QCOMPARE(stylus.history->at(again + 50ms)->validity, Validity::Tracked);
    }

    /// Windows look at a history many times a second.
    void holdsNoMoreOfALongRecordingThanOfADevice()
    {
        constexpr int kSamples = 2000;
        std::vector<Duration> times;
        for (int i = 0; i < kSamples; ++i)
            times.emplace_back(i * 15ms);
        RecordedTracker tracker{{{toolWith("Stylus", ToolRole::Stylus, times)}}, noClock};
        tracker.advance(at(1s));
        QVERIFY(!tracker.advance(at(1s + (kSamples - 1) * 15ms)));
        const std::vector<SessionTime> played = timesOf(tracker.tools()[0]);
        QCOMPARE(played.size(), PoseHistory::Limits{}.capacity);
        QCOMPARE(played.back(), at(1s + (kSamples - 1) * 15ms));
    }

    void endsAtOnceWithoutSamples()
    {
        RecordedTracker tracker{{}, noClock};
        QVERIFY(!tracker.advance(at(0s)));
        RecordedTracker looped{{}, noClock, Playing::Looped};
        QVERIFY(!looped.advance(at(0s)));
    }

    void playsOnItsThreadAndFromTheBeginningAgain()
    {
        std::latch* lastDue = nullptr;
        SessionTime now{};
        RecordedTracker tracker{twoTools(), [&]() -> std::optional<SessionTime> {
                                    now += 20ms;
                                    if (now == at(200ms))
                                        lastDue->count_down();
                                    return now;
                                }};
        for (int round = 0; round < 2; ++round) {
            std::latch inside{1};
            lastDue = &inside;
            now = at(-20ms);
            QVERIFY(tracker.start());
            inside.wait();
            tracker.stop(); // ends after the step that has begun
            QCOMPARE(timesOf(tracker.tools()[0]), (std::vector{at(0ms), at(100ms), at(200ms)}));
        }
    }
};

CARINA_TEST(RecordedTrackerTest)

} // namespace carina::recorded_tracker_test

#include "tst_recorded_tracker.moc"
