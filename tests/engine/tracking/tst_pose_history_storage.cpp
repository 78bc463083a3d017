#include "engine/tracking/pose_history.h"
#include "tests/support/test_class.h"

#include <array>
#include <limits>
#include <thread>

namespace carina::pose_history_storage_test
{
namespace
{

using namespace std::chrono_literals;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr Duration kCentury = std::chrono::hours{876'000};

SessionTime at(Duration t) { return SessionTime{t}; }

/// A sample whose x, in metres, is its time in milliseconds.
PoseSample sampleAt(Duration t)
{
    return {.time = at(t), .X_FO = RigidTransform::translation({toSeconds(t) * 1e3, 0.0, 0.0})};
}

PoseHistory::Limits keeping(std::size_t capacity)
{
    PoseHistory::Limits limits;
    limits.capacity = capacity;
    return limits;
}

std::vector<int> millisecondsKept(const PoseHistory& history)
{
    std::vector<int> kept;
    for (const PoseSample& sample : history.samples())
        kept.push_back(static_cast<int>(sample.time.time_since_epoch() / 1ms));
    return kept;
}

} // namespace

/// What PoseHistory keeps, refuses and lets go, and that several threads may use it at once.
class PoseHistoryStorageTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void sortsWhatComesLateIntoItsPlace()
    {
        PoseHistory history{keeping(5)};
        for (const Duration t : {30ms, 10ms, 20ms, 50ms, 40ms})
            QVERIFY(history.push(sampleAt(t)));
        QCOMPARE(millisecondsKept(history), (std::vector{10, 20, 30, 40, 50}));
        QCOMPARE(history.newest()->time, at(50ms));
    }

    void replacesTheSampleOfTheSameTime()
    {
        PoseHistory history{keeping(2)};
        history.push(sampleAt(10ms));
        history.push(sampleAt(20ms));
        for (const Duration t : {10ms, 20ms}) {
            PoseSample other = sampleAt(t);
            other.error = 0.5;
            QVERIFY(history.push(other));
        }
        QCOMPARE(millisecondsKept(history), (std::vector{10, 20}));
        for (const PoseSample& sample : history.samples())
            QCOMPARE(sample.error, 0.5);
    }

    void letsTheOldestGoWhenFull()
    {
        PoseHistory history{keeping(3)};
        for (const Duration t : {10ms, 20ms, 40ms})
            QVERIFY(history.push(sampleAt(t)));
        QCOMPARE(millisecondsKept(history), (std::vector{10, 20, 40}));
        QVERIFY(history.push(sampleAt(50ms)));
        QCOMPARE(millisecondsKept(history), (std::vector{20, 40, 50}));
        QVERIFY(history.push(sampleAt(30ms)));
        QCOMPARE(millisecondsKept(history), (std::vector{30, 40, 50}));
    }

    void refusesWhatIsOlderThanEverythingOnlyWhenFull()
    {
        PoseHistory history{keeping(3)};
        history.push(sampleAt(30ms));
        history.push(sampleAt(40ms));
        QVERIFY(history.push(sampleAt(20ms)));
        QVERIFY(!history.push(sampleAt(10ms)));
        QCOMPARE(millisecondsKept(history), (std::vector{20, 30, 40}));
    }

    void keepsNothingWithoutCapacity()
    {
        PoseHistory history{keeping(0)};
        QVERIFY(!history.push(sampleAt(10ms)));
        QVERIFY(history.samples().empty());
    }

    void keeps512SamplesAndBridgesAndPredicts150MillisecondsByDefault()
    {
        PoseHistory history;
        for (int i = 0; i < 513; ++i)
            history.push(sampleAt(i * 150ms));
        QCOMPARE(history.samples().size(), std::size_t{512});
        QCOMPARE(history.samples().front().time, at(150ms));
        const SessionTime newest = history.newest()->time;
        QCOMPARE(history.at(newest - 1ms)->validity, Validity::Tracked);
        QCOMPARE(history.at(newest + 150ms)->validity, Validity::Tracked);
        QCOMPARE(history.at(newest + 150ms + 1ns)->validity, Validity::Lost);
        history.push(sampleAt(513 * 150ms + 1ns));
        QCOMPARE(history.at(newest + 75ms)->validity, Validity::Lost);
    }

    void refusesWhatIsNotFinite_data()
    {
        QTest::addColumn<PoseSample>("sample");
        const auto with = [](auto&& change) {
            PoseSample sample = sampleAt(10ms);
            sample.motion = Motion{};
            change(sample);
            return sample;
        };
        QTest::newRow("position NaN") << with([](PoseSample& s) {
            s.X_FO = RigidTransform::translation({0.0, kNaN, 0.0});
        });
        QTest::newRow("position infinite") << with([](PoseSample& s) {
            s.X_FO = RigidTransform::translation({0.0, 0.0, -kInfinity});
        });
        QTest::newRow("velocity") << with([](PoseSample& s) { s.motion->v_FO.x() = kNaN; });
        QTest::newRow("angular velocity")
            << with([](PoseSample& s) { s.motion->w_FO.z() = kInfinity; });
        QTest::newRow("error") << with([](PoseSample& s) { s.error = kNaN; });
    }
    void refusesWhatIsNotFinite()
    {
        QFETCH(PoseSample, sample);
        PoseHistory history;
        QVERIFY(!history.push(sample));
        QVERIFY(history.samples().empty());
    }

    void refusesTimesBeyondACentury_data()
    {
        QTest::addColumn<qint64>("time");
        QTest::addColumn<bool>("taken");
        QTest::newRow("a century on") << qint64{kCentury.count()} << true;
        QTest::newRow("a nanosecond later") << qint64{kCentury.count() + 1} << false;
        QTest::newRow("a century back") << qint64{-kCentury.count()} << true;
        QTest::newRow("a nanosecond earlier") << qint64{-kCentury.count() - 1} << false;
        QTest::newRow("the end of the clock") << std::numeric_limits<qint64>::max() << false;
        QTest::newRow("its beginning") << std::numeric_limits<qint64>::min() << false;
    }
    void refusesTimesBeyondACentury()
    {
        QFETCH(qint64, time);
        QFETCH(bool, taken);
        PoseHistory history;
        PoseSample sample = sampleAt(0ms);
        sample.time = at(Duration{time});
        QCOMPARE(history.push(sample), taken);
    }

    void givesTheNewestAsItCame()
    {
        PoseHistory history;
        QVERIFY(!history.newest());
        PoseSample sample = sampleAt(10ms);
        sample.how = How::Predicted;
        history.push(sample);
        QCOMPARE(history.newest()->how, How::Predicted);
        QVERIFY(!history.newest()->motion);
        history.clear();
        QVERIFY(!history.newest());
        QVERIFY(history.samples().empty());
    }

    void givesWhatWasAddedSinceACursor()
    {
        PoseHistory history{keeping(4)};
        history.push(sampleAt(10ms));
        const auto since = [&](std::uint64_t& cursor) {
            const PoseHistory::Added added = history.since(cursor);
            cursor = added.cursor;
            std::vector<SessionTime> times;
            for (const PoseSample& sample : added.samples)
                times.push_back(sample.time);
            return times;
        };
        std::uint64_t cursor = history.end();
        QVERIFY(since(cursor).empty());
        history.push(sampleAt(30ms));
        history.push(sampleAt(20ms)); // late
        QCOMPARE(since(cursor), (std::vector{at(20ms), at(30ms)}));
        QVERIFY(since(cursor).empty());
        history.push(sampleAt(15ms)); // later still
        QCOMPARE(since(cursor), std::vector{at(15ms)});
        for (const Duration t : {40ms, 50ms, 60ms, 70ms, 80ms}) // more than are kept
            history.push(sampleAt(t));
        QCOMPARE(since(cursor), (std::vector{at(50ms), at(60ms), at(70ms), at(80ms)}));
        history.clear();
        QVERIFY(since(cursor).empty());
        history.push(sampleAt(10ms));
        QCOMPARE(since(cursor), std::vector{at(10ms)});
    }

    /// Every writer owns the times of one remainder, so that each sample of all of them must be
    /// there in the end; readers check that what they see is whole.
    void servesSeveralThreadsAtOnce()
    {
        constexpr int kWriters = 3;
        constexpr int kSamplesEach = 400;
        constexpr double kTolerance = 1e-6; // m, of x against time in ms
        PoseHistory history{keeping(kWriters * kSamplesEach)};
        std::array<int, 2> torn{};
        {
            std::vector<std::jthread> threads;
            for (int writer = 0; writer < kWriters; ++writer) {
                threads.emplace_back([&history, writer] {
                    for (int i = 0; i < kSamplesEach; ++i)
                        history.push(sampleAt((kWriters * i + writer) * 1ms));
                });
            }
            for (int& tornHere : torn) {
                threads.emplace_back([&history, &tornHere] {
                    for (int i = 0; i < kSamplesEach; ++i) {
                        const SessionTime t = at(3 * i * 1ms + 500us);
                        const std::optional<PoseSample> seen = history.at(t);
                        if (seen && seen->how == How::Interpolated
                            && std::abs(seen->X_FO.translation().x() - (3.0 * i + 0.5))
                                   > kTolerance)
                            ++tornHere;
                    }
                });
            }
        }
        QCOMPARE(torn[0] + torn[1], 0);
        const std::vector<int> kept = millisecondsKept(history);
        QCOMPARE(kept.size(), std::size_t{kWriters * kSamplesEach});
        for (std::size_t i = 0; i < kept.size(); ++i)
            QCOMPARE(kept[i], static_cast<int>(i));
    }
};

CARINA_TEST(PoseHistoryStorageTest)

} // namespace carina::pose_history_storage_test

#include "tst_pose_history_storage.moc"
