#include "engine/sync/clock_estimate.h"
#include "tests/engine/sync/session_world.h"

#include <QTest>

#include <random>

namespace carina
{
namespace
{

using namespace std::chrono_literals;

constexpr Duration kOffset = 3h;

/// A probe over a path with these delays, to a host that answers after `hold`.
ClockProbe probe(LocalTime sent, Duration out, Duration back, Duration offset = kOffset,
                 Duration hold = 1ms)
{
    const SessionTime hostReceived{(sent + out).time_since_epoch() + offset};
    return {sent, hostReceived, hostReceived + hold, sent + out + hold + back};
}

LocalTime at(Duration t) { return LocalTime{t}; }

ClockEstimate setAt(LocalTime start, Duration offset, Duration halfRoundTrip)
{
    ClockEstimate clock;
    for (int i = 0; i < ClockEstimate::kProbesToSet; ++i)
        clock.addProbe(probe(start + i * 10ms, halfRoundTrip, halfRoundTrip, offset, 0ms));
    return clock;
}

} // namespace

class TestClockEstimate : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isSetByTheFifthProbe()
    {
        ClockEstimate clock;
        for (int i = 0; i < 4; ++i)
            clock.addProbe(probe(at(i * 10ms), 5ms, 5ms));
        QVERIFY(!clock.mapping());
        QVERIFY(clock.isAcquiring());
        clock.addProbe(probe(at(40ms), 5ms, 5ms));
        QVERIFY(clock.mapping());
        QVERIFY(!clock.isAcquiring());
        QCOMPARE(clock.mapping()->at(at(1s)), SessionTime{1s + kOffset});
    }

    void errorIsHalfTheDifferenceOfTheDelays()
    {
        // 20 ms out and 10 ms back: the estimate is 5 ms ahead, its bound half the round trip.
        ClockEstimate clock;
        for (int i = 0; i < 5; ++i)
            clock.addProbe(probe(at(i * 40ms), 20ms, 10ms));
        const LocalTime last = at(4 * 40ms + 31ms);
        QCOMPARE(clock.mapping()->at(last).time_since_epoch(),
                 last.time_since_epoch() + kOffset + 5ms);
        QCOMPARE(clock.uncertainty(last), Duration{15ms});
    }

    void believesTheShortestRoundTrip()
    {
        ClockEstimate clock;
        clock.addProbe(probe(at(0ms), 90ms, 10ms));
        clock.addProbe(probe(at(100ms), 4ms, 4ms));
        for (int i = 2; i < 5; ++i)
            clock.addProbe(probe(at(i * 100ms), 10ms, 50ms));
        QCOMPARE(clock.mapping()->at(at(1s)), SessionTime{1s + kOffset});
        // 4 ms, and 100 ppm of the second since then.
        QCOMPARE(clock.uncertainty(at(1109ms)), Duration{4ms + 100us});
    }

    void olderProbesAreBelievedLess()
    {
        ClockEstimate clock = setAt(at(0ms), kOffset, 4ms);
        const LocalTime first = at(48ms); // when the last probe came back
        // Ten seconds cost 1 ms of bound: a half round trip of 5 ms is as good by then.
        clock.addProbe(probe(first + 10s - 1us - 10ms, 5ms, 5ms, kOffset + 1ms, 0ms));
        QCOMPARE(clock.uncertainty(first + 10s - 1us), Duration{5ms - 1ns}); // the old one, aged
        clock.addProbe(probe(first + 10s - 10ms, 5ms, 5ms, kOffset + 1ms, 0ms));
        QCOMPARE(clock.uncertainty(first + 10s), Duration{6ms}); // its 5 ms and 1 ms to be slewed
    }

    void ignoresANegativeRoundTrip()
    {
        ClockEstimate clock;
        for (int i = 0; i < 10; ++i)
            clock.addProbe(probe(at(i * 10ms), -2ms, 1ms));
        QVERIFY(!clock.mapping());
    }

    void correctionsAreSlewedNotStepped()
    {
        ClockEstimate clock = setAt(at(0ms), kOffset, 5ms);
        const LocalTime start = at(10s);
        clock.addProbe(probe(start - 2ms, 1ms, 1ms, kOffset + 2ms, 0ms));
        const ClockMapping mapping = *clock.mapping();
        QCOMPARE(mapping.at(start).time_since_epoch(), start.time_since_epoch() + kOffset);
        QCOMPARE(mapping.toGo(start), Duration{2ms});
        // 500 ppm: 0.5 ms after a second, all of it after four.
        QCOMPARE(mapping.at(start + 1s).time_since_epoch(), Duration{11s + kOffset + 500us});
        QCOMPARE(mapping.at(start + 4s).time_since_epoch(), Duration{14s + kOffset + 2ms});
        QCOMPARE(mapping.at(start + 9s).time_since_epoch(), Duration{19s + kOffset + 2ms});
        QCOMPARE(mapping.toGo(start + 9s), Duration{});
        QCOMPARE(clock.uncertainty(start), Duration{3ms});
        // The past is not rewritten.
        QCOMPARE(mapping.at(start - 1s).time_since_epoch(), Duration{9s + kOffset});
    }

    void correctionsTheOtherWayNeverRunBackwards()
    {
        ClockEstimate clock = setAt(at(0ms), kOffset, 60ms);
        clock.addProbe(probe(at(10s - 2ms), 1ms, 1ms, kOffset - 40ms, 0ms));
        const ClockMapping mapping = *clock.mapping();
        SessionTime last = mapping.at(at(9s));
        for (LocalTime t = at(9s); t < at(100s); t += 7ms) {
            QVERIFY(mapping.at(t + 7ms) > last);
            last = mapping.at(t + 7ms);
        }
        QCOMPARE(mapping.at(at(90s)).time_since_epoch(), Duration{90s + kOffset - 40ms});
    }

    void newCorrectionGoesOnFromTheOld()
    {
        ClockMapping mapping{at(0s), kOffset};
        mapping.slewTo(kOffset + 2ms, at(0s));
        mapping.slewTo(kOffset - 1ms, at(2s)); // half of it done
        QCOMPARE(mapping.at(at(2s)).time_since_epoch(), Duration{2s + kOffset + 1ms});
        QCOMPARE(mapping.toGo(at(2s)), Duration{-2ms});
        QCOMPARE(mapping.at(at(3s)).time_since_epoch(), Duration{3s + kOffset + 500us});
        QCOMPARE(mapping.at(at(10s)).time_since_epoch(), Duration{10s + kOffset - 1ms});
    }

    void hostThatComesBackCloseByIsSlewedTo()
    {
        ClockEstimate clock = setAt(at(0ms), kOffset, 1ms);
        clock.reacquire();
        QVERIFY(clock.isAcquiring());
        for (int i = 0; i < 4; ++i)
            clock.addProbe(probe(at(10s + i * 10ms), 1ms, 1ms, kOffset + 50ms, 0ms));
        // Meanwhile the clock runs on.
        QCOMPARE(clock.mapping()->at(at(10s)).time_since_epoch(), Duration{10s + kOffset});
        clock.addProbe(probe(at(10s + 40ms), 1ms, 1ms, kOffset + 50ms, 0ms));
        const LocalTime now = at(10s + 42ms);
        QCOMPARE(clock.mapping()->at(now).time_since_epoch(), now.time_since_epoch() + kOffset);
        QCOMPARE(clock.mapping()->toGo(now), Duration{50ms});
    }

    void hostThatComesBackFarOffIsTakenAtItsWord()
    {
        ClockEstimate clock = setAt(at(0ms), kOffset, 1ms);
        clock.reacquire();
        for (int i = 0; i < 5; ++i)
            clock.addProbe(probe(at(10s + i * 10ms), 1ms, 1ms, kOffset + 50ms + 1us, 0ms));
        const LocalTime now = at(11s);
        QCOMPARE(clock.mapping()->at(now).time_since_epoch(),
                 now.time_since_epoch() + kOffset + 50ms + 1us);
    }

    void firstProbeAfterAReturnDisplacesABetterOld()
    {
        ClockEstimate clock = setAt(at(0ms), kOffset, 1ms);
        clock.reacquire();
        clock.addProbe(probe(at(1s), 20ms, 20ms, kOffset + 3ms, 0ms));
        for (int i = 1; i < 5; ++i)
            clock.addProbe(probe(at(1s + i * 100ms), 40ms, 40ms, kOffset + 9ms, 0ms));
        QCOMPARE(clock.mapping()->toGo(at(1s + 480ms)), Duration{3ms});
    }

    void extremeTimesDoNotOverflow()
    {
        const Duration far{std::int64_t{1} << 61};
        ClockEstimate clock;
        for (int i = 0; i < 5; ++i)
            clock.addProbe({LocalTime{-far}, SessionTime{far}, SessionTime{far}, LocalTime{-far}});
        QCOMPARE(clock.mapping()->at(LocalTime{-far}), SessionTime{far});
    }

    void staysWithinItsBoundUnderJitter_data()
    {
        QTest::addColumn<int>("delayUs");
        QTest::addColumn<int>("jitterUs");
        QTest::addColumn<double>("loss");
        QTest::addColumn<int>("skewPpm");
        QTest::newRow("lan") << 100 << 20 << 0.0 << 50;
        QTest::newRow("wi-fi") << 2000 << 3000 << 0.005 << -50;
        QTest::newRow("metro") << 8000 << 500 << 0.001 << 50;
        QTest::newRow("wan") << 40000 << 2000 << 0.005 << -50;
        QTest::newRow("storm") << 20000 << 30000 << 0.2 << 50;
    }

    void staysWithinItsBoundUnderJitter()
    {
        QFETCH(int, delayUs);
        QFETCH(int, jitterUs);
        QFETCH(double, loss);
        QFETCH(int, skewPpm);
        SessionWorld world{21};
        world.addSite(
            {std::chrono::microseconds{delayUs}, std::chrono::microseconds{jitterUs}, loss, loss},
            {-250ms, skewPpm});
        world.startClient(0, "anna");
        auto& site = world.site(0);
        Duration worst{};
        std::optional<SessionTime> last;
        bool monotone = true;
        bool bounded = true;
        world.run(300s, 10ms, [&] {
            const auto& mapping = site.client->clock().mapping();
            if (!mapping)
                return;
            const LocalTime local = site.clock.at(world.now());
            const SessionTime now = mapping->at(local);
            monotone = monotone && (!last || now > *last);
            last = now;
            const Duration error = std::chrono::abs(now - world.trueSessionTime());
            bounded = bounded && error <= site.client->clock().uncertainty(local);
            if (world.now() > 60s)
                worst = std::max(worst, error);
        });
        QVERIFY(monotone);
        QVERIFY(bounded);
        // Once settled: within half of the shortest round trip there is.
        QVERIFY2(worst <= std::chrono::microseconds{delayUs},
                 std::to_string(toSeconds(worst) * 1e3).c_str());
    }
};

} // namespace carina

QTEST_GUILESS_MAIN(carina::TestClockEstimate)
#include "tst_clock_estimate.moc"
