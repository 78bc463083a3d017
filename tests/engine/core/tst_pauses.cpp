#include "engine/core/pauses.h"

#include "tests/support/test_class.h"

namespace carina::pauses_test
{
namespace
{

using namespace std::chrono_literals;

/// From 10 to 20 s, and from 30 s on for good.
Pauses twoPauses()
{
    Pauses pauses;
    pauses.add(SessionTime{10s}, SessionTime{20s});
    pauses.add(SessionTime{30s}, SessionTime::max());
    return pauses;
}

Duration between(Duration from, Duration until)
{
    return twoPauses().between(SessionTime{from}, SessionTime{until});
}

SessionTime after(Duration from, Duration time)
{
    return twoPauses().after(SessionTime{from}, time);
}

} // namespace

class TestPauses : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void containsABeginAndNoEnd()
    {
        const Pauses pauses = twoPauses();
        QVERIFY(!pauses.contains(SessionTime{10s} - Duration{1}));
        QVERIFY(pauses.contains(SessionTime{10s}));
        QVERIFY(pauses.contains(SessionTime{20s} - Duration{1}));
        QVERIFY(!pauses.contains(SessionTime{20s}));
        QVERIFY(pauses.contains(SessionTime{9999s}));
        QVERIFY(!Pauses{}.contains(SessionTime{15s}));
    }

    void countsTheTimeBesideThem()
    {
        QCOMPARE(between(0s, 5s), Duration{5s});
        QCOMPARE(between(5s, 15s), Duration{5s});
        QCOMPARE(between(12s, 18s), Duration{0s});
        QCOMPARE(between(5s, 25s), Duration{10s});
        QCOMPARE(between(0s, 99s), Duration{20s});
        QCOMPARE(between(5s, 2s), Duration{0s});
        QCOMPARE(Pauses{}.between(SessionTime{3s}, SessionTime{7s}), Duration{4s});
    }

    void findsWhenATimeHasPassed()
    {
        QVERIFY(after(3s, 4s) == SessionTime{7s});
        QVERIFY(after(3s, 7s) == SessionTime{10s}); // before the pause
        QVERIFY(after(3s, 8s) == SessionTime{21s});
        QVERIFY(after(12s, 0s) == SessionTime{12s});
        QVERIFY(after(12s, 1s) == SessionTime{21s});
        QVERIFY(after(25s, 5s) == SessionTime{30s});
        QVERIFY(after(25s, 6s) == SessionTime::max());
        QVERIFY(Pauses{}.after(SessionTime{3s}, 4s) == SessionTime{7s});
    }

    /// One is what the other says.
    void agreesWithItself()
    {
        for (Duration from = 0s; from < 30s; from += 500ms)
            for (Duration time = 0s; time < 10s; time += 700ms)
                if (const SessionTime end = after(from, time); end < SessionTime::max())
                    QCOMPARE(twoPauses().between(SessionTime{from}, end), time);
    }
};

CARINA_TEST(TestPauses)

} // namespace carina::pauses_test

#include "tst_pauses.moc"
