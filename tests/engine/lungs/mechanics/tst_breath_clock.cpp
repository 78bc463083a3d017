#include "tests/engine/lungs/mechanics/clock_listener.h"
#include "tests/engine/lungs/mechanics/within.h"
#include "tests/support/test_class.h"

#include <random>

namespace carina::breath_clock_test
{

using namespace carina::test;

class TestBreathClock : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void runsAtTheRateSet();
    void comesToANewRateByItsSlew();
    void locksToTheManikin_data();
    void locksToTheManikin();
    void neverJumpsOrRunsBack();
    void goesBackToTheRateSetWhenTheManikinStops();
    void waitsForASecondBreath();
    void doesNotBelieveDoubleBreaths();
    void doesNotBelieveAPauseToBeABreath();
    void usesTheTimeOfTheBreathNotOfTheNews();
    void goesOnFromItsState();
};

void TestBreathClock::runsAtTheRateSet()
{
    Listener listener;
    listener.until(60.0);
    VERIFY_WITHIN(listener.clock.state().breaths, 16.0, 1e-3);
    listener.until(61.0);
    VERIFY_WITHIN(listener.clock.phase(), 16.0 / 60.0, 1e-3);
    QVERIFY(!listener.clock.isLocked());
}

/// Half of the faster rate per second: from 16 down to 8 in 1 s is a fall of 50 % of 16.
void TestBreathClock::comesToANewRateByItsSlew()
{
    BreathClock up{perMinute(12.0)};
    up.advance(perMinute(24.0), 0.5);
    VERIFY_WITHIN(inPerMinute(up.state().rate), 18.0, 1e-9);
    up.advance(perMinute(24.0), 0.6);
    VERIFY_WITHIN(inPerMinute(up.state().rate), 24.0, 1e-9);
    BreathClock down{perMinute(16.0)};
    down.advance(perMinute(8.0), 0.5);
    VERIFY_WITHIN(inPerMinute(down.state().rate), 12.0, 1e-9);
}

void TestBreathClock::locksToTheManikin_data()
{
    QTest::addColumn<double>("rate_perMin");
    QTest::addColumn<double>("from_s");
    QTest::newRow("slower") << 10.0 << 3.3;
    QTest::newRow("as set, out of step") << 16.0 << 5.6;
    QTest::newRow("faster") << 24.0 << 2.1;
    QTest::newRow("fast") << 40.0 << 7.0;
}

void TestBreathClock::locksToTheManikin()
{
    QFETCH(const double, rate_perMin);
    QFETCH(const double, from_s);
    const double period = 60.0 / rate_perMin;
    constexpr int kBreaths = 12;
    Listener listener;
    listener.hear(from_s, period, kBreaths);
    QVERIFY(listener.clock.isLocked());
    VERIFY_WITHIN(listener.phaseErrorAt(from_s + (kBreaths - 1) * period), 0.0, 0.01);
    VERIFY_WITHIN(listener.rate_perMin() / rate_perMin, 1.0, 0.02);
}

/// Whatever it hears: the phase only grows, by no more than the fastest rate, and the rate changes
/// by no more than its slew.
void TestBreathClock::neverJumpsOrRunsBack()
{
    std::mt19937 random{7};
    std::uniform_real_distribution<double> gap{0.2, 12.0};
    Listener listener;
    double next = gap(random);
    double breaths = 0.0;
    double rate = kSet.si;
    for (int i = 0; i < 200000; ++i) {
        listener.clock.advance(kSet, kClockStep);
        listener.now += kClockStep;
        const BreathClock::State& state = listener.clock.state();
        QVERIFY(state.breaths > breaths);
        const double fastest = kFastestManikin.si * (1.0 + kMostPull);
        QVERIFY(state.breaths - breaths <= fastest * kClockStep * 1.000001);
        const double most = kSlew * std::max(rate, fastest) * kClockStep;
        QVERIFY(std::abs(state.rate.si - rate) <= most * 1.000001);
        breaths = state.breaths;
        rate = state.rate.si;
        if (listener.now >= next) {
            listener.clock.trigger(listener.now - next);
            next += gap(random);
        }
    }
}

void TestBreathClock::goesBackToTheRateSetWhenTheManikinStops()
{
    Listener listener;
    listener.hear(1.0, 3.0, 12); // the last at 34 s
    listener.until(34.0 + 3.0 * kPatience - 0.1);
    QVERIFY(listener.clock.isLocked());
    VERIFY_WITHIN(listener.rate_perMin(), 20.0, 0.1);
    listener.until(34.0 + 3.0 * kPatience + 0.1);
    QVERIFY(!listener.clock.isLocked());
    listener.until(50.0);
    VERIFY_WITHIN(listener.rate_perMin(), 16.0, 1e-9);
    QCOMPARE(listener.clock.state().measured.si, 0.0);
}

void TestBreathClock::waitsForASecondBreath()
{
    Listener listener;
    listener.hearAt(2.0);
    listener.until(4.0);
    QVERIFY(!listener.clock.isLocked());
    VERIFY_WITHIN(listener.rate_perMin(), 16.0, 1e-9);
    listener.hearAt(5.0);
    QVERIFY(listener.clock.isLocked());
    VERIFY_WITHIN(inPerMinute(listener.clock.state().measured), 20.0, 0.05);
}

void TestBreathClock::doesNotBelieveDoubleBreaths()
{
    Listener once;
    once.hear(1.0, 3.0, 6);
    Listener twice;
    for (int i = 0; i < 6; ++i) {
        twice.hearAt(1.0 + 3.0 * i);
        twice.hearAt(1.9 + 3.0 * i);
    }
    twice.until(17.0);
    once.until(twice.now);
    QVERIFY(once.clock.state() == twice.clock.state());
}

void TestBreathClock::doesNotBelieveAPauseToBeABreath()
{
    Listener listener;
    listener.hearAt(1.0);
    listener.hearAt(17.0); // slower than 4 a minute
    QVERIFY(!listener.clock.isLocked());
    QCOMPARE(listener.clock.state().measured.si, 0.0);
    listener.hearAt(20.0);
    QVERIFY(listener.clock.isLocked());
}

/// News of a breath that come late lead to the same lock.
void TestBreathClock::usesTheTimeOfTheBreathNotOfTheNews()
{
    Listener listener;
    for (int i = 0; i < 12; ++i) {
        listener.until(1.15 + 3.0 * i);
        listener.clock.trigger(0.15);
    }
    VERIFY_WITHIN(inPerMinute(listener.clock.state().measured), 20.0, 0.05);
    VERIFY_WITHIN(listener.phaseErrorAt(34.0), 0.0, 0.01);
}

void TestBreathClock::goesOnFromItsState()
{
    Listener through;
    through.hear(1.0, 2.9, 5);
    Listener again{BreathClock{through.clock.state()}, through.now};
    through.hear(15.0, 2.9, 5);
    again.hear(15.0, 2.9, 5);
    QVERIFY(again.clock.state() == through.clock.state());
}

CARINA_TEST(TestBreathClock)

} // namespace carina::breath_clock_test

#include "tst_breath_clock.moc"
