#include "tests/engine/sync/strategies/strategy_star.h"
#include "tests/support/test_class.h"

namespace carina::session_clock_test
{
namespace
{

using namespace std::chrono_literals;
using test::quarterTurns;
using test::StrategyStar;
using test::turnedAboutZ_deg;

constexpr ObjectId kObject{1};
constexpr double kTolerance_deg = 1e-4;
/// A header and an event, a header and an acknowledgement.
constexpr std::size_t kEventBytes = 34 + 94;
constexpr std::size_t kAckBytes = 34 + 9;
constexpr std::size_t kProbeBytes = 34;

std::vector<Duration> eventsFrom(const StrategyStar& star, std::uint16_t from, std::uint16_t to,
                                 Duration since, std::size_t bytes = kEventBytes)
{
    std::vector<Duration> times;
    for (const auto& departure : star.departures())
        if (departure.from == from && departure.to == to && departure.bytes == bytes)
            times.push_back(departure.at - since);
    return times;
}

} // namespace

class TestSessionClock : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void repeatsAnEventUntilItIsAcknowledged()
    {
        // The acknowledgement is there after 80 ms, before the fifth repeat.
        StrategyStar star{"session-clock", 2, {.toHost = 40ms, .fromHost = 40ms}};
        star.runTo(5s);
        star.forgetDepartures();
        star.act(1, quarterTurns());
        star.runTo(5099ms);
        QCOMPARE(eventsFrom(star, 1, 0, 5s), (std::vector<Duration>{0ms, 10ms, 30ms, 50ms, 70ms}));
        QCOMPARE(eventsFrom(star, 0, 2, 5s), (std::vector<Duration>{40ms, 50ms, 70ms, 90ms}));
    }

    void sendsAnEventOnceOverAShortPath()
    {
        StrategyStar star{"session-clock", 3, {.toHost = 1ms, .fromHost = 1ms}};
        star.runTo(5s);
        star.forgetDepartures();
        star.act(1, quarterTurns());
        star.runTo(5099ms);
        QCOMPARE(eventsFrom(star, 1, 0, 5s), (std::vector<Duration>{0ms}));
        QCOMPARE(eventsFrom(star, 0, 1, 5s), (std::vector<Duration>{}));
        QCOMPARE(eventsFrom(star, 0, 2, 5s), (std::vector<Duration>{1ms}));
        QCOMPARE(eventsFrom(star, 0, 3, 5s), (std::vector<Duration>{1ms}));
        // The heartbeat, passed on and acknowledged by all, is as long as its acknowledgement.
        star.runTo(5199ms);
        QCOMPARE(eventsFrom(star, 1, 0, 5s), (std::vector<Duration>{0ms}));
        QCOMPARE(eventsFrom(star, 1, 0, 5s, kAckBytes), (std::vector<Duration>{100ms}));
        QCOMPARE(eventsFrom(star, 0, 2, 5s), (std::vector<Duration>{1ms}));
        QCOMPARE(eventsFrom(star, 0, 2, 5s, kAckBytes), (std::vector<Duration>{101ms}));
        // It is passed on to one after the other, so that no answers wait for each other.
        QCOMPARE(eventsFrom(star, 0, 3, 5s, kAckBytes), (std::vector<Duration>{103ms}));
        QCOMPARE(eventsFrom(star, 0, 1, 5s, kAckBytes), (std::vector<Duration>{1ms, 101ms}));
        QCOMPARE(eventsFrom(star, 2, 0, 5s, kAckBytes), (std::vector<Duration>{2ms, 102ms}));
    }

    void losesNothingWhenTheFirstIsLost()
    {
        StrategyStar star{"session-clock", 2, {}};
        star.runTo(5s);
        star.loseIf(
            [](const auto& departure) { return departure.from == 1 && departure.at < 5s + 10ms; });
        star.act(1, quarterTurns());
        star.runTo(5s + 29ms);
        QVERIFY(!star.shown(2, kObject));
        star.runTo(5s + 30ms);
        QVERIFY(std::abs(turnedAboutZ_deg(star.shown(2, kObject)) - 90.0 * 0.030) < kTolerance_deg);
    }

    void hostRepeatsToEachViewerByItself()
    {
        StrategyStar star{"session-clock", 3, {}};
        star.runTo(5s);
        star.loseIf(
            [](const auto& departure) { return departure.to == 3 && departure.at < 5s + 40ms; });
        star.act(1, quarterTurns());
        star.runTo(5s + 49ms);
        QVERIFY(star.shown(2, kObject));
        QVERIFY(!star.shown(3, kObject));
        star.runTo(5s + 50ms); // sent again 30 ms after 5010 ms
        QVERIFY(star.shown(3, kObject));
    }

    void ownerKeepsControlOfWhatWasOvertaken()
    {
        // Everything to the viewer of the first action waits until after the second.
        StrategyStar star{"session-clock", 2, {}};
        star.runTo(5s);
        star.act(1, quarterTurns(1));
        star.setLegs(2, {.toHost = 10ms, .fromHost = 300ms});
        star.runTo(5s + 20ms);
        star.setLegs(2, {.toHost = 10ms, .fromHost = 10ms});
        EventCpo rest = quarterTurns(2);
        rest.rate = 0.0F;
        star.act(1, rest);
        star.runTo(6s);
        QCOMPARE(turnedAboutZ_deg(star.shown(2, kObject)), 0.0);
    }

    void marksAnObjectStaleWhenItsOwnerIsGone()
    {
        StrategyStar star{"session-clock", 2, {}};
        star.runTo(5s);
        star.act(1, quarterTurns());
        star.runTo(6s);
        QVERIFY(!star.shown(2, kObject)->isStale);
        // The last heartbeat left 910 ms after the action and arrived 20 ms later.
        star.loseIf([](const auto& departure) { return departure.from == 1; });
        star.runTo(6s + 230ms);
        QVERIFY(!star.shown(2, kObject)->isStale);
        star.runTo(6s + 230ms + 1ns);
        QVERIFY(star.shown(2, kObject)->isStale);
        star.runTo(6s + 450ms);
        QVERIFY(star.shown(2, kObject)->isStale);
        // It is drawn on all the same, and at the owner's it is not stale.
        QVERIFY(std::abs(turnedAboutZ_deg(star.shown(2, kObject)) - 90.0 * 1.45) < kTolerance_deg);
        QVERIFY(!star.shown(1, kObject)->isStale);
        star.loseIf(nullptr);
        star.runTo(7s);
        QVERIFY(!star.shown(2, kObject)->isStale);
    }

    void healsAPartition()
    {
        StrategyStar star{"session-clock", 2, {}};
        star.runTo(5s);
        star.act(1, quarterTurns(1));
        star.runTo(6s);
        star.loseIf([](const auto&) { return true; });
        star.runTo(7s);
        EventCpo rest = quarterTurns(2);
        rest.rate = 0.0F;
        rest.q_AO = Quat{0.0, 1.0, 0.0, 0.0};
        star.act(1, rest);
        star.runTo(8s);
        star.loseIf(nullptr);
        star.runTo(8s + 250ms);
        QVERIFY(std::abs(star.shown(2, kObject)->acted.X_AO.rotation().x()) > 1.0 - 1e-12);
    }

    void actsBeforeItsClockIsSet()
    {
        StrategyStar star{"session-clock", 2, {}};
        star.act(1, quarterTurns());
        star.runTo(1s);
        QVERIFY(std::abs(turnedAboutZ_deg(star.shown(1, kObject)) - 90.0) < kTolerance_deg);
        QVERIFY(std::abs(turnedAboutZ_deg(star.shown(2, kObject)) - 90.0) < kTolerance_deg);
    }

    void clockIsSetWithin300Milliseconds()
    {
        StrategyStar star{"session-clock", 2, {}};
        star.setOffset(2, 77s);
        star.runTo(300ms);
        const auto session = star.participant(2).sessionTime(star.local(2));
        QVERIFY(session);
        QVERIFY(std::chrono::abs(*session - SessionTime{300ms}) < 1us);
    }

    void idleParticipantProbesOnceASecondAndTheHostAlone()
    {
        StrategyStar star{"session-clock", 4, {}};
        star.runTo(200s);
        star.forgetDepartures();
        const std::uint64_t before = star.participant(3).probesSent();
        star.runTo(260s);
        QCOMPARE(star.participant(3).probesSent() - before, 60U);
        QCOMPARE(star.sent(3, 0), 60U);
        QCOMPARE(star.sent(0, 3), 60U);
        QVERIFY(std::ranges::all_of(star.departures(), [](const auto& departure) {
            return departure.bytes == kProbeBytes;
        }));
    }

    void needsNoProbesWhileEventsGo()
    {
        StrategyStar star{"session-clock", 3, {}};
        star.runTo(5s);
        star.act(1, quarterTurns());
        star.runTo(10s);
        const std::uint64_t before = star.participant(1).probesSent()
                                     + star.participant(2).probesSent()
                                     + star.participant(3).probesSent();
        star.forgetDepartures();
        star.runTo(20s);
        QCOMPARE(star.participant(1).probesSent() + star.participant(2).probesSent()
                     + star.participant(3).probesSent(),
                 before);
        // Ten heartbeats a second, each acknowledged.
        QCOMPARE(star.sent(1, 0), 100U);
        QCOMPARE(star.sent(0, 1), 100U);
        QCOMPARE(star.sent(0, 2), 100U);
        QCOMPARE(star.sent(2, 0), 100U);
        QVERIFY(std::ranges::all_of(
            star.departures(), [](const auto& departure) { return departure.bytes == kAckBytes; }));
    }

    void dropsWhatIsNoDatagram()
    {
        StrategyStar star{"session-clock", 2, {}};
        star.runTo(5s);
        const std::vector<std::byte> garbage(50, std::byte{0x43});
        star.participant(2).receive(kStarHost, garbage, star.local(2));
        star.participant(2).receive(kStarHost, {}, star.local(2));
        star.act(1, quarterTurns());
        star.runTo(6s);
        QVERIFY(std::abs(turnedAboutZ_deg(star.shown(2, kObject)) - 90.0) < kTolerance_deg);
    }
};

CARINA_TEST(TestSessionClock)

} // namespace carina::session_clock_test

#include "tst_session_clock.moc"
