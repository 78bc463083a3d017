#include "engine/sync/clock/peer_clock.h"
#include "tests/support/test_class.h"

#include <cmath>

namespace carina::peer_clock_test
{
namespace
{

using namespace std::chrono_literals;

constexpr Duration kTold = 2us; ///< that a fit of undisturbed probes is off at most
constexpr Duration kOffset = 3h + 17ms;

SessionTime at(Duration t) { return SessionTime{5h + t}; }

/// A round trip that the host ends at `end`: the participant's clock reads session time less
/// `offset`, the way out and back takes `out` and `back`, and it answers after `hold`.
void exchange(PeerClock& clock, Duration end, Duration offset, Duration out, Duration back,
              Duration hold = 7ms)
{
    const Duration answered = at(end).time_since_epoch() - back;
    clock.add({LocalTime{}, answered - offset, hold, out + back}, at(end));
}

Duration apart(const PeerClock& clock, Duration t, Duration offset)
{
    return std::chrono::abs(clock.offset(at(t)).value() - offset);
}

} // namespace

class TestPeerClock : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void knowsNothingBeforeTenExchanges()
    {
        PeerClock clock;
        QVERIFY(!clock.offset(at(0s)));
        for (int i = 0; i < 9; ++i)
            exchange(clock, i * 100ms, kOffset, 10ms, 10ms);
        QVERIFY(!clock.offset(at(1s)));
        exchange(clock, 900ms, kOffset, 10ms, 10ms);
        QVERIFY(clock.offset(at(1s)));
    }

    void findsTheOffset_data()
    {
        QTest::addColumn<qint64>("out_ms");
        QTest::addColumn<qint64>("back_ms");
        QTest::newRow("a symmetric path") << qint64{20} << qint64{20};
        // What no two clocks can see: half of the difference.
        QTest::newRow("slower out") << qint64{50} << qint64{30};
        QTest::newRow("slower back") << qint64{30} << qint64{50};
    }

    void findsTheOffset()
    {
        QFETCH(const qint64, out_ms);
        QFETCH(const qint64, back_ms);
        PeerClock clock;
        for (int i = 0; i < 50; ++i)
            exchange(clock, i * 100ms, kOffset, out_ms * 1ms, back_ms * 1ms);
        const Duration unseen = (out_ms - back_ms) * 1ms / 2;
        QVERIFY(apart(clock, 5s, kOffset - unseen) < kTold);
        QCOMPARE(clock.bound(at(5s)), (out_ms + back_ms) * 1ms / 2);
        QVERIFY(std::chrono::abs(unseen) <= clock.bound(at(5s)));
    }

    void howLongAnAnswerWasHeldDoesNotMatter()
    {
        PeerClock clock;
        for (int i = 0; i < 50; ++i)
            exchange(clock, i * 100ms, kOffset, 10ms, 10ms, i * 5ms);
        QVERIFY(apart(clock, 5s, kOffset) < kTold);
        QCOMPARE(clock.trigger().history().mean(), Duration{10ms});
        QCOMPARE(clock.trigger().history().sigma(), Duration{0ms});
    }

    void followsAClockThatRunsFast()
    {
        PeerClock clock;
        const auto offsetAt = [](Duration t) { return kOffset - t / 20'000; }; // 50 ppm
        for (int i = 0; i < 300; ++i)
            exchange(clock, i * 100ms, offsetAt(i * 100ms), 10ms, 10ms);
        QVERIFY(apart(clock, 30s, offsetAt(30s)) < 50us);
        QVERIFY(apart(clock, 32s, offsetAt(32s)) < 50us);
    }

    void isLessSureOfWhatItDoesNotHear()
    {
        PeerClock clock;
        for (int i = 0; i < 50; ++i)
            exchange(clock, i * 100ms, kOffset, 10ms, 10ms);
        QVERIFY(clock.uncertainty(at(1h)) > clock.uncertainty(at(5s)));
    }

    void absurdReadingsAreIgnored_data()
    {
        QTest::addColumn<qint64>("reading"); // nanoseconds
        QTest::newRow("the largest there is") << std::numeric_limits<qint64>::max();
        QTest::newRow("the least there is") << std::numeric_limits<qint64>::min();
        QTest::newRow("just above") << (qint64{1} << 61) + 1;
        QTest::newRow("just below") << -(qint64{1} << 61) - 1;
    }

    void absurdReadingsAreIgnored()
    {
        QFETCH(const qint64, reading);
        PeerClock clock;
        clock.add({LocalTime{}, Duration{reading}, 0s, 1ms}, at(0s));
        QCOMPARE(clock.trigger().history().size(), 0U);
        clock.add({LocalTime{}, Duration{(reading > 0 ? 1 : -1) * (qint64{1} << 61)}, 0s, 1ms},
                  at(0s));
        QCOMPARE(clock.trigger().history().size(), 1U);
    }
};

CARINA_TEST(TestPeerClock)

} // namespace carina::peer_clock_test

#include "tst_peer_clock.moc"
