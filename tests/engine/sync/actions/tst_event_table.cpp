#include "engine/sync/actions/event_table.h"
#include "tests/support/test_class.h"

namespace carina::event_table_test
{
namespace
{

using namespace std::chrono_literals;
using Verdict = EventTable::Verdict;

constexpr LocalTime kNow{1h};
constexpr SessionTime kSession{50h};
constexpr ObjectId kObject{1};

/// Moves along x at 2 m/s from `from` on, from the time `start`.
EventCpo moving(std::uint32_t action, double from, SessionTime start)
{
    EventCpo event;
    event.object = kObject;
    event.action = action;
    event.kind = ActionKind::Translation;
    event.start = start;
    event.p_AO = Vec3{from, 0.0, 0.0};
    event.rate = 2.0F;
    return event;
}

double xAt(const EventTable& table, SessionTime t)
{
    return evaluate(*table.inForce(kObject, t), t).X_AO.translation().x();
}

} // namespace

class TestEventTable : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void knowsNothingOfAnObjectNeverHeardOf()
    {
        const EventTable table;
        QVERIFY(table.inForce(kObject, kSession) == nullptr);
        QVERIFY(!table.isStale(kObject, kNow));
        QVERIFY(table.newest(kObject) == nullptr);
    }

    void evaluatesTheActionExactly()
    {
        EventTable table;
        QCOMPARE(table.take(moving(1, 3.0, kSession), kSession + 40ms, kNow), Verdict::New);
        QCOMPARE(xAt(table, kSession + 250ms), 3.5);
        QCOMPARE(xAt(table, kSession + 100s), 203.0);
        QCOMPARE(table.newest(kObject)->action, 1U);
    }

    void knowsTheNewestActionByItsName()
    {
        EventTable table;
        const EventCpo event = moving(5, 3.0, kSession);
        const EventBeat beat{kObject, event.epoch, 5};
        QVERIFY(table.named(beat) == nullptr);
        table.take(moving(4, 1.0, kSession), kSession, kNow);
        QVERIFY(table.named(beat) == nullptr);
        table.take(event, kSession, kNow);
        QVERIFY(table.named(beat) == table.newest(kObject));
        QVERIFY(table.named({kObject, static_cast<std::uint16_t>(event.epoch + 1), 5}) == nullptr);
        QVERIFY(table.named({ObjectId{99}, event.epoch, 5}) == nullptr);
        table.take(moving(6, 3.0, kSession), kSession, kNow);
        QVERIFY(table.named(beat) == nullptr);
    }

    /// With local lag several actions of one owner wait for their start.
    void actionsBeginOneAfterTheOther()
    {
        EventTable table;
        for (std::uint32_t action = 1; action <= 4; ++action)
            table.take(moving(action, 10.0 * action, kSession + action * 10ms), kSession, kNow);
        QCOMPARE(xAt(table, kSession), 10.0);
        for (std::uint32_t action = 1; action <= 4; ++action) {
            QCOMPARE(xAt(table, kSession + action * 10ms), 10.0 * action);
            QVERIFY(xAt(table, kSession + action * 10ms + 9ms) < 10.0 * action + 1.0);
        }
    }

    void latestWinsInAnyOrder()
    {
        EventTable table;
        QCOMPARE(table.take(moving(2, 10.0, kSession), kSession, kNow), Verdict::New);
        QCOMPARE(table.take(moving(1, 0.0, kSession - 5s), kSession, kNow), Verdict::Old);
        QCOMPARE(xAt(table, kSession), 10.0);
        QCOMPARE(table.take(moving(2, 10.0, kSession), kSession, kNow), Verdict::Known);
        QCOMPARE(table.take(moving(3, 20.0, kSession), kSession, kNow), Verdict::New);
        QCOMPARE(xAt(table, kSession), 20.0);
    }

    void actionBeforeGoesOnUntilTheNextBegins()
    {
        EventTable table;
        QCOMPARE(table.take(moving(1, 0.0, kSession), kSession, kNow), Verdict::New);
        QCOMPARE(table.take(moving(2, 7.0, kSession + 1s), kSession, kNow), Verdict::New);
        QCOMPARE(xAt(table, kSession + 500ms), 1.0);
        QCOMPARE(xAt(table, kSession + 1s), 7.0);
        QCOMPARE(xAt(table, kSession + 1500ms), 8.0);
    }

    void isStaleAfter300MillisecondsOfSilence()
    {
        EventTable table;
        table.take(moving(2, 0.0, kSession), kSession, kNow);
        QVERIFY(!table.isStale(kObject, kNow + 300ms));
        QVERIFY(table.isStale(kObject, kNow + 300ms + 1ns));
        table.take(moving(2, 0.0, kSession), kSession, kNow + 200ms);
        QVERIFY(!table.isStale(kObject, kNow + 500ms));
        // What comes late from the time before says nothing of now.
        table.take(moving(1, 0.0, kSession), kSession, kNow + 400ms);
        QVERIFY(table.isStale(kObject, kNow + 500ms + 1ns));
    }

    void refusesAnActionFarAhead()
    {
        EventTable table;
        QCOMPARE(table.take(moving(1, 0.0, kSession + 10s + 1ns), kSession, kNow),
                 Verdict::Refused);
        QVERIFY(table.newest(kObject) == nullptr);
        QCOMPARE(table.take(moving(1, 0.0, kSession + 10s), kSession, kNow), Verdict::New);
        // Without a clock there is nothing to judge it by.
        QCOMPARE(table.take(moving(2, 0.0, kSession + 99h), std::nullopt, kNow), Verdict::New);
    }
};

CARINA_TEST(TestEventTable)

} // namespace carina::event_table_test

#include "tst_event_table.moc"
