#include "engine/tracking/delivery_thread.h"
#include "engine/tracking/simulated/simulated_tracker.h"
#include "tests/support/test_class.h"

#include <atomic>
#include <latch>

namespace carina::delivery_thread_test
{
namespace
{

using namespace std::chrono_literals;

/// A clock that goes on by a millisecond whenever it is read.
class SteppingClock
{
public:
    std::optional<SessionTime> operator()() { return SessionTime{++m_readings * 1ms}; }

private:
    int m_readings = 0;
};

} // namespace

/// The thread of the trackers. Each test waits for the thread by a latch that the thread releases.
class DeliveryThreadTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void callsTheStepWithTheTimeOfTheClock()
    {
        std::latch thrice{3};
        std::vector<SessionTime> times;
        DeliveryThread thread{SteppingClock{}, [&](SessionTime now) -> std::optional<SessionTime> {
                                  times.push_back(now);
                                  thrice.count_down();
                                  if (times.size() == 3)
                                      return std::nullopt;
                                  return now;
                              }};
        QVERIFY(thread.start());
        thrice.wait();
        thread.stop();
        const SessionTime zero{};
        QCOMPARE(times, (std::vector{zero + 1ms, zero + 2ms, zero + 3ms}));
    }

    void waitsUntilTheClockIsSet()
    {
        std::latch called{1};
        int readings = 0;
        DeliveryThread thread{[&]() -> std::optional<SessionTime> {
                                  if (++readings < 3)
                                      return std::nullopt;
                                  return SessionTime{7ms};
                              },
                              [&](SessionTime) -> std::optional<SessionTime> {
                                  called.count_down();
                                  return std::nullopt;
                              }};
        QVERIFY(thread.start());
        called.wait();
        thread.stop();
        QCOMPARE(readings, 3);
    }

    void readsTheClockAgainWhileTheNextStepIsFarOff()
    {
        std::latch twice{2};
        std::atomic<int> steps = 0;
        DeliveryThread thread{SteppingClock{}, [&](SessionTime now) -> std::optional<SessionTime> {
                                  if (++steps <= 2)
                                      twice.count_down();
                                  return now + std::chrono::hours{1};
                              }};
        QVERIFY(thread.start());
        twice.wait();
        thread.stop();
    }

    void stopsAndStartsAgain()
    {
        std::atomic<int> running = 0;
        std::latch first{1};
        std::latch second{1};
        std::atomic<std::latch*> awaited = &first;
        DeliveryThread thread{SteppingClock{}, [&](SessionTime now) -> std::optional<SessionTime> {
                                  ++running;
                                  if (std::latch* latch = awaited.exchange(nullptr))
                                      latch->count_down();
                                  --running;
                                  return now + 1ms;
                              }};
        thread.stop(); // harmless before the start
        QVERIFY(thread.start());
        QVERIFY(thread.start()); // and once more while it runs
        first.wait();
        thread.stop();
        QCOMPARE(running.load(), 0);
        awaited = &second;
        QVERIFY(thread.start());
        second.wait();
        thread.stop();
    }

    void endsAWaitOfAnHour()
    {
        std::latch waiting{1};
        bool hasEnded = false;
        StoppableThread thread{[&](const std::stop_token& stopping) {
            waiting.count_down();
            thread.rest(std::chrono::hours{1}, stopping);
            hasEnded = true;
        }};
        QVERIFY(thread.start());
        waiting.wait();
        thread.stop();
        QVERIFY(hasEnded);
    }

    void deliversThePosesOfTheSimulatedTracker()
    {
        constexpr int kExposures = 20;
        std::latch exposed{4 * kExposures};
        std::atomic<int> left = 4 * kExposures;
        SimulatedTrackerSettings settings;
        settings.rate = hertz(1000.0);
        settings.latency = Duration::zero();
        SimulatedTracker tracker{settings,
                                 [&](ToolRole, SessionTime) {
                                     if (--left >= 0)
                                         exposed.count_down();
                                     return RigidTransform::translation({0.0, 0.0, -1.0});
                                 },
                                 SteppingClock{}};
        QVERIFY(tracker.start());
        exposed.wait();
        tracker.stop();
        for (const TrackedTool& tool : tracker.tools())
            QVERIFY(tool.history->samples().size() >= std::size_t{kExposures});
    }
};

CARINA_TEST(DeliveryThreadTest)

} // namespace carina::delivery_thread_test

#include "tst_delivery_thread.moc"
