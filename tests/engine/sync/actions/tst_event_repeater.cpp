#include "engine/sync/actions/event_repeater.h"
#include "tests/support/test_class.h"

namespace carina::event_repeater_test
{
namespace
{

using namespace std::chrono_literals;

constexpr LocalTime kStart{1h};

EventCpo eventOf(std::uint16_t object, std::uint32_t action, std::uint16_t epoch = 0)
{
    EventCpo event;
    event.object = ObjectId{object};
    event.epoch = epoch;
    event.action = action;
    return event;
}

/// When the repeater sends within the time, asked only when it says so.
std::vector<Duration> sendings(EventRepeater& repeater, Duration until)
{
    std::vector<Duration> times;
    while (repeater.nextDue() <= kStart + until) {
        const LocalTime now = repeater.nextDue();
        if (!repeater.takeDue(now).empty())
            times.push_back(now - kStart);
    }
    return times;
}

} // namespace

class TestEventRepeater : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void repeatsAfter10And30MillisecondsAndThenEvery20()
    {
        EventRepeater repeater{false};
        repeater.begin(eventOf(1, 1), kStart);
        QCOMPARE(sendings(repeater, 100ms),
                 (std::vector<Duration>{0ms, 10ms, 30ms, 50ms, 70ms, 90ms}));
    }

    void stopsWhenAcknowledged()
    {
        EventRepeater repeater{false};
        repeater.begin(eventOf(1, 7, 2), kStart);
        QCOMPARE(repeater.takeDue(kStart).size(), 1U);
        repeater.acknowledge({ObjectId{1}, 2, 7});
        QCOMPARE(repeater.nextDue(), LocalTime::max());
        QVERIFY(repeater.takeDue(kStart + 10s).empty());
    }

    void goesOnWhenAnotherIsAcknowledged_data()
    {
        QTest::addColumn<int>("object");
        QTest::addColumn<int>("epoch");
        QTest::addColumn<int>("action");
        QTest::newRow("another object") << 2 << 2 << 7;
        QTest::newRow("the ownership before") << 1 << 1 << 7;
        QTest::newRow("the action before") << 1 << 2 << 6;
        QTest::newRow("the action after") << 1 << 2 << 8;
    }
    void goesOnWhenAnotherIsAcknowledged()
    {
        QFETCH(int, object);
        QFETCH(int, epoch);
        QFETCH(int, action);
        EventRepeater repeater{false};
        repeater.begin(eventOf(1, 7, 2), kStart);
        repeater.acknowledge({ObjectId{static_cast<std::uint16_t>(object)},
                              static_cast<std::uint16_t>(epoch),
                              static_cast<std::uint32_t>(action)});
        QCOMPARE(sendings(repeater, 40ms), (std::vector<Duration>{0ms, 10ms, 30ms}));
    }

    void ownerHasAHeartbeat()
    {
        EventRepeater repeater{true};
        repeater.begin(eventOf(1, 1), kStart);
        QCOMPARE(sendings(repeater, 0ms), (std::vector<Duration>{0ms}));
        repeater.acknowledge({ObjectId{1}, 0, 1});
        QCOMPARE(sendings(repeater, 350ms), (std::vector<Duration>{100ms, 200ms, 300ms}));
    }

    void secondAcknowledgementDoesNotMoveTheHeartbeat()
    {
        EventRepeater repeater{true};
        repeater.begin(eventOf(1, 1), kStart);
        QCOMPARE(sendings(repeater, 10ms).size(), 2U);
        repeater.acknowledge({ObjectId{1}, 0, 1});
        QCOMPARE(repeater.nextDue(), kStart + 110ms);
        QCOMPARE(repeater.takeDue(kStart + 110ms).size(), 1U);
        repeater.acknowledge({ObjectId{1}, 0, 1});
        QCOMPARE(repeater.nextDue(), kStart + 210ms);
    }

    void namesAnAcknowledgedActionInItsBeats()
    {
        EventRepeater repeater{true};
        repeater.begin(eventOf(1, 7, 2), kStart);
        QVERIFY(std::holds_alternative<EventCpo>(repeater.takeDue(kStart).at(0).record()));
        QVERIFY(std::holds_alternative<EventCpo>(repeater.takeDue(kStart + 10ms).at(0).record()));
        repeater.acknowledge({ObjectId{1}, 2, 7});
        const WireRecord record = repeater.takeDue(kStart + 110ms).at(0).record();
        const auto* beat = std::get_if<EventBeat>(&record);
        QVERIFY(beat);
        QCOMPARE(beat->object, ObjectId{1});
        QCOMPARE(beat->epoch, std::uint16_t{2});
        QCOMPARE(beat->action, 7U);
    }

    void sendsTheWholeActionWhenTenBeatsWereForNothing()
    {
        EventRepeater repeater{true};
        repeater.begin(eventOf(1, 7, 2), kStart);
        QCOMPARE(repeater.takeDue(kStart).size(), 1U);
        repeater.acknowledge({ObjectId{1}, 2, 7});
        const auto isBeat = [&] { return repeater.takeDue(repeater.nextDue()).at(0).isBeat; };
        for (int beat = 1; beat <= 10; ++beat)
            QVERIFY(isBeat());
        QVERIFY(!isBeat());
        QVERIFY(!isBeat());
        repeater.acknowledge({ObjectId{1}, 2, 7});
        QVERIFY(isBeat());
    }

    void sendsTheWholeActionWhereItIsInDoubt()
    {
        EventRepeater repeater{true};
        repeater.begin(eventOf(1, 7, 2), kStart);
        QCOMPARE(repeater.takeDue(kStart).size(), 1U);
        repeater.acknowledge({ObjectId{1}, 2, 7});
        repeater.doubt();
        QVERIFY(!repeater.takeDue(kStart + 100ms).at(0).isBeat);
        QVERIFY(!repeater.takeDue(kStart + 200ms).at(0).isBeat);
        repeater.acknowledge({ObjectId{1}, 2, 7});
        QVERIFY(repeater.takeDue(kStart + 300ms).at(0).isBeat);
    }

    void newActionTakesThePlaceOfTheLast()
    {
        EventRepeater repeater{false};
        repeater.begin(eventOf(1, 1), kStart - 5ms);
        QCOMPARE(repeater.takeDue(kStart - 5ms).size(), 1U);
        repeater.begin(eventOf(1, 2), kStart);
        const auto due = repeater.takeDue(kStart);
        QCOMPARE(due.size(), 1U);
        QCOMPARE(due[0].event.action, 2U);
        QVERIFY(!due[0].isBeat);
        QCOMPARE(sendings(repeater, 40ms), (std::vector<Duration>{10ms, 30ms}));
    }

    void objectsAreRepeatedEachByItself()
    {
        EventRepeater repeater{false};
        repeater.begin(eventOf(1, 1), kStart);
        repeater.begin(eventOf(2, 5), kStart + 4ms);
        QCOMPARE(sendings(repeater, 40ms),
                 (std::vector<Duration>{0ms, 4ms, 10ms, 14ms, 30ms, 34ms}));
    }

    void passesHeartbeatsOnNoSoonerThan50Milliseconds()
    {
        EventRepeater repeater{false};
        const EventCpo event = eventOf(1, 1);
        repeater.begin(event, kStart);
        QCOMPARE(repeater.takeDue(kStart).size(), 1U);
        repeater.acknowledge({ObjectId{1}, 0, 1});
        repeater.beat(event, kStart + 50ms - 1ns);
        QCOMPARE(repeater.nextDue(), LocalTime::max());
        repeater.beat(event, kStart + 50ms);
        QCOMPARE(repeater.takeDue(kStart + 50ms).size(), 1U);
        QCOMPARE(repeater.nextDue(), LocalTime::max());
        repeater.beat(eventOf(9, 1), kStart + 200ms);
        QCOMPARE(repeater.nextDue(), LocalTime::max());
    }

    void laterIsByEpochAndThenByCounter_data()
    {
        QTest::addColumn<int>("epochA");
        QTest::addColumn<quint32>("actionA");
        QTest::addColumn<int>("epochB");
        QTest::addColumn<quint32>("actionB");
        QTest::addColumn<bool>("isLater");
        QTest::newRow("the same") << 1 << 5U << 1 << 5U << false;
        QTest::newRow("next action") << 1 << 6U << 1 << 5U << true;
        QTest::newRow("action before") << 1 << 4U << 1 << 5U << false;
        QTest::newRow("next epoch, lower counter") << 2 << 1U << 1 << 5U << true;
        QTest::newRow("epoch before, higher counter") << 0 << 9U << 1 << 5U << false;
        QTest::newRow("counter has wrapped") << 1 << 0U << 1 << 0xFFFFFFFFU << true;
        QTest::newRow("epoch has wrapped") << 0 << 1U << 0xFFFF << 1U << true;
    }
    void laterIsByEpochAndThenByCounter()
    {
        QFETCH(int, epochA);
        QFETCH(quint32, actionA);
        QFETCH(int, epochB);
        QFETCH(quint32, actionB);
        QFETCH(bool, isLater);
        QCOMPARE(carina::isLater(eventOf(1, actionA, static_cast<std::uint16_t>(epochA)),
                                 eventOf(1, actionB, static_cast<std::uint16_t>(epochB))),
                 isLater);
    }
};

CARINA_TEST(TestEventRepeater)

} // namespace carina::event_repeater_test

#include "tst_event_repeater.moc"
