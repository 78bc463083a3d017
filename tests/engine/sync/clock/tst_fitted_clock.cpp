#include "engine/sync/clock/fitted_clock.h"
#include "tests/support/test_class.h"

#include <cmath>
#include <random>

namespace carina::fitted_clock_test
{
namespace
{

using namespace std::chrono_literals;

constexpr Duration kOffset = 3h;
constexpr Duration kRounding = 2ns;

LocalTime at(Duration t) { return LocalTime{t}; }

/// The host's clock, fast by `skew`, at a local time.
SessionTime hostAt(LocalTime t, double skew)
{
    const auto local = t.time_since_epoch();
    return SessionTime{local + kOffset
                       + Duration{std::llround(skew * static_cast<double>(local.count()))}};
}

/// A probe over a path with these delays, to a host that answers after `hold`.
ClockProbe probe(LocalTime sent, Duration out, Duration back, double skew = 0.0,
                 Duration hold = 1ms)
{
    return {sent, hostAt(sent + out, skew), hostAt(sent + out + hold, skew),
            sent + out + hold + back};
}

/// How far the clock is off at t.
Duration errorAt(const FittedClock& clock, LocalTime t, double skew = 0.0)
{
    return clock.mapping()->at(t) - hostAt(t, skew);
}

/// Probes every `interval` over a path of 10 ms each way, from 0 on.
FittedClock afterSteadyProbes(int count, Duration interval, double skew = 0.0)
{
    FittedClock clock;
    for (int i = 0; i < count; ++i)
        clock.addProbe(probe(at(i * interval), 10ms, 10ms, skew));
    return clock;
}

/// Queues of exponential length in both directions.
class Queues
{
public:
    explicit Queues(std::uint32_t seed, Duration mean) : m_random{seed}, m_mean{mean} {}
    Duration next()
    {
        const double unit = static_cast<double>(m_random()) / 4294967296.0;
        return fromSeconds(-toSeconds(m_mean) * std::log1p(-unit));
    }

private:
    std::mt19937 m_random;
    Duration m_mean;
};

} // namespace

class TestFittedClock : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isSetByTheTenthProbe()
    {
        FittedClock clock = afterSteadyProbes(9, 20ms);
        QVERIFY(!clock.mapping());
        QVERIFY(clock.isAcquiring());
        QCOMPARE(clock.stateAt(at(1s)), FittedClock::State::Acquiring);
        clock.addProbe(probe(at(180ms), 10ms, 10ms));
        QVERIFY(!clock.isAcquiring());
        QCOMPARE(clock.stateAt(at(1s)), FittedClock::State::Locked);
        QVERIFY(std::chrono::abs(errorAt(clock, at(1s))) <= kRounding);
        QCOMPARE(clock.bound(at(1s)), Duration{10ms});
    }

    void findsOffsetAndSkewOfASteadyPath_data()
    {
        QTest::addColumn<double>("skew");
        QTest::newRow("alike") << 0.0;
        QTest::newRow("host fast by 50 ppm") << 50e-6;
        QTest::newRow("host slow by 300 ppm") << -300e-6;
    }
    void findsOffsetAndSkewOfASteadyPath()
    {
        // Once the first setting is worked off, it holds between probes and after the last.
        QFETCH(double, skew);
        const FittedClock clock = afterSteadyProbes(200, 100ms, skew);
        QVERIFY(std::abs(clock.skew() - skew) < 1e-8);
        QVERIFY(std::chrono::abs(errorAt(clock, at(20s), skew)) < 100ns);
        QVERIFY(std::chrono::abs(errorAt(clock, at(23s), skew)) < 150ns);
    }

    void externalClocksSeeTheAsymmetry()
    {
        // 25 and 55 ms: the probes are 15 ms off, within 40, which has the variance 1600/3 ms^2.
        // The external offset is right, and says 2 ms.
        FittedClock clock;
        for (int i = 0; i < 600; ++i) {
            const LocalTime t = at(i * 100ms);
            clock.setExternal({t, kOffset, 2ms});
            clock.addProbe(probe(t, 25ms, 55ms));
        }
        const double share = (1600.0 / 3.0) / (1600.0 / 3.0 + 4.0);
        const LocalTime end = at(60s);
        QVERIFY(std::abs(toSeconds(errorAt(clock, end)) + (1.0 - share) * 15e-3) < 1e-6);
        QVERIFY(clock.external());
        QVERIFY(!clock.external()->isRefused);
        QVERIFY(std::chrono::abs(clock.external()->difference - 15ms) < 1us);
        QCOMPARE(clock.external()->error, Duration{2ms});
        // Standard error of the weighted mean; the bound still holds the truth.
        QVERIFY(std::abs(clock.uncertainty(end) - 2e-3 * std::sqrt(share)) < 1e-6);
        QVERIFY(std::abs(toSeconds(clock.bound(end)) - (40e-3 + share * 15e-3)) < 1e-5);
    }

    void externalClockBeyondTheRoundTripIsRefused_data()
    {
        QTest::addColumn<int>("off_ms");
        QTest::addColumn<bool>("isRefused");
        // Half the round trip is 10 ms, three standard errors are 3.
        QTest::newRow("within") << 12 << false;
        QTest::newRow("beyond") << 14 << true;
        QTest::newRow("beyond, slow") << -14 << true;
        QTest::newRow("an hour") << 3'600'000 << true;
    }
    void externalClockBeyondTheRoundTripIsRefused()
    {
        QFETCH(int, off_ms);
        QFETCH(bool, isRefused);
        FittedClock clock;
        const FittedClock without = afterSteadyProbes(600, 100ms);
        for (int i = 0; i < 600; ++i) {
            const LocalTime t = at(i * 100ms);
            clock.setExternal({t, kOffset + off_ms * 1ms, 1ms});
            clock.addProbe(probe(t, 10ms, 10ms));
        }
        QCOMPARE(clock.external()->isRefused, isRefused);
        QVERIFY(std::chrono::abs(clock.external()->difference - off_ms * 1ms) < 1us);
        if (isRefused) // as if there were none
            QCOMPARE(clock.mapping()->at(at(60s)), without.mapping()->at(at(60s)));
        else // never further than the round trip permits
            QVERIFY(std::chrono::abs(errorAt(clock, at(60s))) <= 10ms + kRounding);
    }

    void oldExternalOffsetHasNoEffect()
    {
        FittedClock clock;
        clock.setExternal({at(0s), kOffset + 5ms, 1ms});
        for (int i = 0; i < 800; ++i)
            clock.addProbe(probe(at(i * 100ms), 10ms, 10ms));
        QVERIFY(!clock.external());
        QVERIFY(std::chrono::abs(errorAt(clock, at(80s))) < 100ns);
    }

    void poorExternalClocksHardlyMatter()
    {
        // A LAN of 0.1 ms each way knows better than a clock that says 5 ms.
        FittedClock clock;
        for (int i = 0; i < 600; ++i) {
            const LocalTime t = at(i * 100ms);
            clock.setExternal({t, kOffset + 4ms, 5ms});
            clock.addProbe(probe(t, 100us, 100us));
        }
        QVERIFY(std::chrono::abs(errorAt(clock, at(60s))) < 1us);
    }

    void readingsAtBothEndsGiveTheOffset()
    {
        // 1970 and the session's and this program's clocks; 3 ms and 4 ms, of an age of 0.
        const ExternalTime host{1000h - 7s, 3ms};
        const ExternalTime own{1000h, 4ms};
        const ExternalOffset offset = externalOffset(host, own, 0s, at(5s));
        QCOMPARE(offset.offset, Duration{7s});
        QVERIFY(std::abs(toSeconds(offset.error) - 5e-3) < 1e-9);
        QCOMPARE(offset.at, at(5s));
        // 100 ppm of 120 s are 12 ms, and it is as old as the older reading.
        const ExternalOffset old = externalOffset(host, own, 120s, at(125s));
        QVERIFY(std::abs(toSeconds(old.error) - 13e-3) < 1e-9);
        QCOMPARE(old.at, at(5s));
    }

    void longHoldDoesNotShiftTheClock()
    {
        // The host answers after 90 ms of its clock: the offset is that of the middle.
        FittedClock clock;
        const double skew = 200e-6;
        for (int i = 0; i < 200; ++i)
            clock.addProbe(probe(at(i * 100ms), 1ms, 1ms, skew, 90ms));
        QVERIFY(std::chrono::abs(errorAt(clock, at(20s), skew)) < 100ns);
    }

    void errorIsHalfTheDifferenceOfTheDelays()
    {
        FittedClock clock;
        for (int i = 0; i < 20; ++i)
            clock.addProbe(probe(at(i * 100ms), 20ms, 10ms));
        QVERIFY(std::chrono::abs(errorAt(clock, at(2s)) - 5ms) <= kRounding);
        QCOMPARE(clock.bound(at(2s)), Duration{15ms});
    }

    void believesShortRoundTrips()
    {
        // Every other probe waits 20 ms on its way out, which would put the mean 5 ms off.
        FittedClock clock;
        for (int i = 0; i < 100; ++i)
            clock.addProbe(probe(at(i * 100ms), i % 2 == 0 ? 30ms : 10ms, 10ms));
        QVERIFY(std::chrono::abs(errorAt(clock, at(10s))) < 200us);
    }

    void findsTheClockThroughQueues_data()
    {
        QTest::addColumn<int>("seed");
        for (int seed = 1; seed <= 5; ++seed)
            QTest::addRow("seed %d", seed) << seed;
    }
    void findsTheClockThroughQueues()
    {
        // Queues of 1 ms in both directions, a probe ten times a second. A line through all probes
        // has a standard error of 1 ms / sqrt(2 * 450) * 2 = 0.067 ms at its end.
        QFETCH(int, seed);
        Queues queues{static_cast<std::uint32_t>(seed), 1ms};
        constexpr double kSkew = 50e-6;
        FittedClock clock;
        double squares = 0.0;
        for (int i = 0; i < 1200; ++i) {
            clock.addProbe(probe(at(i * 100ms), 20ms + queues.next(), 20ms + queues.next(), kSkew));
            if (i >= 200) {
                const double error = toSeconds(errorAt(clock, at(i * 100ms + 90ms), kSkew));
                squares += error * error / 1000.0;
            }
        }
        QVERIFY2(std::sqrt(squares) < 0.05e-3, qPrintable(QString::number(std::sqrt(squares))));
        // It knows how well it knows, or less.
        const double stated = clock.uncertainty(at(1199 * 100ms + 41ms));
        QVERIFY(stated > 0.02e-3 && stated < 0.1e-3);
    }

    void neverJumpsWhileLive()
    {
        // The path gets 4 ms longer one way: the clock works the 2 ms off at 500 ppm.
        FittedClock clock = afterSteadyProbes(100, 100ms);
        SessionTime last = clock.mapping()->at(at(10s));
        for (int i = 100; i < 400; ++i) {
            clock.addProbe(probe(at(i * 100ms), 14ms, 10ms));
            const LocalTime next = at(i * 100ms + 100ms);
            const Duration step = clock.mapping()->at(next) - last;
            QVERIFY(std::chrono::abs(step - 100ms) <= 100us + kRounding);
            last = clock.mapping()->at(next);
        }
        QVERIFY(std::chrono::abs(errorAt(clock, at(40s)) - 2ms) < 100ns);
    }

    void flushesTheWindowOnAnotherRoute()
    {
        FittedClock clock = afterSteadyProbes(100, 100ms);
        clock.addProbe(probe(at(10s), 20ms, 20ms));
        clock.addProbe(probe(at(10100ms), 20ms, 20ms));
        QVERIFY(!clock.isAcquiring());
        clock.addProbe(probe(at(10200ms), 20ms, 20ms));
        QVERIFY(clock.isAcquiring());
        QCOMPARE(clock.trigger().history().size(), 1U);
        // The clock goes on meanwhile, and then has the new path's bound.
        QVERIFY(std::chrono::abs(errorAt(clock, at(10300ms))) <= kRounding);
        for (int i = 0; i < 9; ++i)
            clock.addProbe(probe(at(10300ms + i * 20ms), 20ms, 20ms));
        QVERIFY(!clock.isAcquiring());
        QCOMPARE(clock.bound(at(11s)), Duration{20ms});
    }

    void twoSlowProbesAreNoOtherRoute()
    {
        FittedClock clock = afterSteadyProbes(100, 100ms);
        for (int i = 0; i < 30; ++i)
            clock.addProbe(probe(at(10s + i * 100ms), i % 3 < 2 ? 200ms : 10ms, 10ms));
        QVERIFY(!clock.isAcquiring());
        QVERIFY(std::chrono::abs(errorAt(clock, at(13s))) < 1ms);
    }

    void keepsNothingOlderThan45Seconds()
    {
        // After 55 s of silence the old probes, 5 ms off, count no more.
        FittedClock clock;
        for (int i = 0; i < 50; ++i)
            clock.addProbe(probe(at(i * 100ms), 20ms, 10ms));
        for (int i = 0; i < 12; ++i)
            clock.addProbe(probe(at(60s + i * 1s), 15ms, 15ms));
        QVERIFY(std::chrono::abs(errorAt(clock, at(95s))) < 100ns);
    }

    void isSetAnewOnAHostThatIsFarOff()
    {
        FittedClock clock = afterSteadyProbes(100, 100ms);
        clock.reacquire();
        QVERIFY(clock.isAcquiring());
        QVERIFY(clock.mapping());
        for (int i = 0; i < 10; ++i) {
            ClockProbe other = probe(at(20s + i * 20ms), 10ms, 10ms);
            other.hostReceived += 51ms;
            other.hostSent += 51ms;
            clock.addProbe(other);
        }
        QVERIFY(std::chrono::abs(errorAt(clock, at(21s)) - 51ms) <= kRounding);
    }

    void ignoresANegativeRoundTrip()
    {
        FittedClock clock = afterSteadyProbes(9, 20ms);
        clock.addProbe(probe(at(200ms), 1ms, -2ms));
        QVERIFY(clock.isAcquiring());
    }

    void extremeTimesDoNotOverflow()
    {
        const Duration far{std::int64_t{1} << 61};
        FittedClock clock;
        for (int i = 0; i < 10; ++i)
            clock.addProbe({LocalTime{-far}, SessionTime{far}, SessionTime{far}, LocalTime{-far}});
        QCOMPARE(clock.mapping()->at(LocalTime{-far}), SessionTime{far});
    }

    void holdsOverWithAGrowingUncertainty()
    {
        const FittedClock clock = afterSteadyProbes(200, 100ms);
        const LocalTime last = at(199 * 100ms + 21ms);
        QCOMPARE(clock.stateAt(last + 3s), FittedClock::State::Locked);
        QCOMPARE(clock.stateAt(last + 3s + 1ns), FittedClock::State::Holdover);
        QVERIFY(clock.uncertainty(last + 3s) < 1e-7);
        // 1 ppm of a minute.
        QVERIFY(std::abs(clock.uncertainty(last + 63s) - 60e-6) < 1e-7);
    }

    void idleNodesProbeBetweenOnceAndTwentyTimesASecond()
    {
        QCOMPARE(kIdleProbes.lowest, 1.0);
        QCOMPARE(kIdleProbes.highest, 20.0);
        QCOMPARE(kIdleProbes.sigmaFloor, Duration{100us});
        const FittedClock clock = afterSteadyProbes(100, 1s);
        QCOMPARE(clock.idleInterval(), Duration{1s});
    }
};

CARINA_TEST(TestFittedClock)

} // namespace carina::fitted_clock_test

#include "tst_fitted_clock.moc"
