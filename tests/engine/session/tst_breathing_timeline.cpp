#include "engine/session/breathing_timeline.h"
#include "tests/engine/session/sample_session.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace carina
{

using test::atSeconds;

class TestBreathingTimeline : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void restsUntilItRuns();
    void countsBreathsAtAConstantRate();
    void integratesARampOfRates();
    void doesNotCountPauses();
    void holdsTheVolumeThroughAPause();
    void takesTidalVolumeAtTheStartOfABreath();
    void takesTheFractionAtTheStartOfABreath();
    void takesSettingsChangedBetweenTwoBreathsIntoTheNext();
    void showsTheSettingsInForce();
    void neverJumps_data();
    void neverJumps();
    void agreesWithPlainSummationWhateverTheOrder();
    void keepsTheLaterOfTwoForOneTime();
    void takesTenThousandChanges();
};

namespace
{

constexpr double kBreathTolerance = 1e-9; // breaths
constexpr double kVolumeTolerance = 1e-6; // ml

/// 15 per minute, 400 ml, a quarter of each 4 s breath inspiration, from 0 s.
BreathingTimeline fourSecondBreaths()
{
    BreathingTimeline timeline;
    timeline.setRate(atSeconds(0.0), perMinute(15.0));
    timeline.setTidalVolume(atSeconds(0.0), millilitres(400.0));
    timeline.setInspiratoryFraction(atSeconds(0.0), 0.25);
    timeline.setRunning(atSeconds(0.0), true);
    return timeline;
}

double inspiredMl(const BreathingTimeline& timeline, double seconds)
{
    return inMillilitres(timeline.inspiredAt(atSeconds(seconds)));
}

#define COMPARE_WITHIN(actual, expected, tolerance)                                                \
    QVERIFY2(std::abs((actual) - (expected)) <= (tolerance),                                       \
             qPrintable(QStringLiteral("%1 instead of %2").arg(actual).arg(expected)))

} // namespace

void TestBreathingTimeline::restsUntilItRuns()
{
    BreathingTimeline timeline;
    QCOMPARE(timeline.breathsAt(atSeconds(100.0)), 0.0);
    QCOMPARE(inspiredMl(timeline, 100.0), 0.0);
    timeline.setRunning(atSeconds(50.0), true);
    QCOMPARE(timeline.breathsAt(atSeconds(50.0)), 0.0);
    QVERIFY(timeline.breathsAt(atSeconds(51.0)) > 0.0);
    QCOMPARE(timeline.breathsAt(atSeconds(-51.0)), 0.0);
}

void TestBreathingTimeline::countsBreathsAtAConstantRate()
{
    const BreathingTimeline timeline = fourSecondBreaths();
    for (const double seconds : {0.0, 1.0, 3.999, 4.0, 61.0, 7200.5})
        COMPARE_WITHIN(timeline.breathsAt(atSeconds(seconds)), seconds / 4.0, kBreathTolerance);
}

/// From 10 to 40 per minute in 3000 steps over 60 s: midpoint steps integrate a straight line
/// exactly, 60 s * 25/60 s = 25 breaths.
void TestBreathingTimeline::integratesARampOfRates()
{
    BreathingTimeline timeline;
    timeline.setRunning(atSeconds(0.0), true);
    constexpr int kSteps = 3000;
    for (int i = 0; i < kSteps; ++i)
        timeline.setRate(atSeconds(60.0 * i / kSteps), perMinute(10.0 + 30.0 * (i + 0.5) / kSteps));
    COMPARE_WITHIN(timeline.breathsAt(atSeconds(60.0)), 25.0, kBreathTolerance);
    // Half-way: integral of (10 + 30 s/60)/60 over 30 s.
    COMPARE_WITHIN(timeline.breathsAt(atSeconds(30.0)), 8.75, kBreathTolerance);
}

void TestBreathingTimeline::doesNotCountPauses()
{
    BreathingTimeline timeline = fourSecondBreaths();
    timeline.setRunning(atSeconds(10.0), false);
    timeline.setRate(atSeconds(15.0), perMinute(30.0)); // while it rests
    timeline.setRunning(atSeconds(20.0), true);
    COMPARE_WITHIN(timeline.breathsAt(atSeconds(10.0)), 2.5, kBreathTolerance);
    COMPARE_WITHIN(timeline.breathsAt(atSeconds(20.0)), 2.5, kBreathTolerance);
    COMPARE_WITHIN(timeline.breathsAt(atSeconds(22.0)), 3.5, kBreathTolerance);
}

void TestBreathingTimeline::holdsTheVolumeThroughAPause()
{
    BreathingTimeline timeline = fourSecondBreaths();
    timeline.setRunning(atSeconds(9.3), false);
    timeline.setTidalVolume(atSeconds(11.0), millilitres(900.0));
    timeline.setInspiratoryFraction(atSeconds(12.0), 0.6);
    timeline.setRate(atSeconds(13.0), perMinute(50.0));
    const double held = inspiredMl(timeline, 9.3);
    QVERIFY(held > 1.0);
    for (double seconds = 9.3; seconds < 100.0; seconds += 0.7)
        QCOMPARE(inspiredMl(timeline, seconds), held);
    timeline.setRunning(atSeconds(100.0), true);
    QCOMPARE(inspiredMl(timeline, 100.0), held);
}

/// At the end of inspiration all of the tidal volume is in.
void TestBreathingTimeline::takesTidalVolumeAtTheStartOfABreath()
{
    BreathingTimeline timeline = fourSecondBreaths();
    timeline.setTidalVolume(atSeconds(0.5), millilitres(800.0));
    timeline.setTidalVolume(atSeconds(8.0), millilitres(300.0));
    timeline.setTidalVolume(atSeconds(12.0) + Duration{1}, millilitres(100.0));
    COMPARE_WITHIN(inspiredMl(timeline, 1.0), 400.0, kVolumeTolerance);
    COMPARE_WITHIN(inspiredMl(timeline, 5.0), 800.0, kVolumeTolerance);
    COMPARE_WITHIN(inspiredMl(timeline, 9.0), 300.0, kVolumeTolerance);
    COMPARE_WITHIN(inspiredMl(timeline, 13.0), 300.0, kVolumeTolerance);
    COMPARE_WITHIN(inspiredMl(timeline, 17.0), 100.0, kVolumeTolerance);
}

void TestBreathingTimeline::takesTheFractionAtTheStartOfABreath()
{
    BreathingTimeline timeline = fourSecondBreaths();
    timeline.setInspiratoryFraction(atSeconds(0.5), 0.5);
    COMPARE_WITHIN(inspiredMl(timeline, 1.0), 400.0, kVolumeTolerance); // after 1 s of 4
    COMPARE_WITHIN(inspiredMl(timeline, 5.0), 200.0, kVolumeTolerance); // half-way
    COMPARE_WITHIN(inspiredMl(timeline, 6.0), 400.0, kVolumeTolerance); // after 2 s of 4
}

void TestBreathingTimeline::takesSettingsChangedBetweenTwoBreathsIntoTheNext()
{
    BreathingTimeline timeline = fourSecondBreaths();
    timeline.setRunning(atSeconds(8.0), false);
    timeline.setTidalVolume(atSeconds(9.0), millilitres(700.0));
    timeline.setRunning(atSeconds(10.0), true);
    QCOMPARE(inspiredMl(timeline, 9.5), 0.0);
    COMPARE_WITHIN(inspiredMl(timeline, 11.0), 700.0, kVolumeTolerance);
}

void TestBreathingTimeline::showsTheSettingsInForce()
{
    BreathingTimeline timeline;
    const BreathingPattern before = timeline.settingsAt(atSeconds(0.0));
    QCOMPARE(before.rate, BreathingPattern{}.rate);
    QCOMPARE(before.tidalVolume, BreathingPattern{}.tidalVolume);
    QCOMPARE(before.inspiratoryFraction, BreathingPattern{}.inspiratoryFraction);
    timeline = fourSecondBreaths();
    timeline.setTidalVolume(atSeconds(0.5), millilitres(800.0));
    const BreathingPattern settings = timeline.settingsAt(atSeconds(0.5));
    QCOMPARE(settings.rate, perMinute(15.0));
    QCOMPARE(settings.tidalVolume, millilitres(800.0)); // though the breath keeps its 400 ml
    QCOMPARE(settings.inspiratoryFraction, 0.25);
}

void TestBreathingTimeline::neverJumps_data()
{
    QTest::addColumn<unsigned>("seed");
    for (const unsigned seed : {1U, 2U, 3U, 4U, 5U, 6U})
        QTest::addRow("seed %u", seed) << seed;
}

/// However rate, tidal volume, fraction and pauses change, gas moves no faster than the steepest
/// breath that the settings ever asked for: half a sine in peaks at VT f pi / (2 fi); passive
/// expiration starts at VT f k / ((1 - exp(-k)) (1 - fi)).
void TestBreathingTimeline::neverJumps()
{
    QFETCH(const unsigned, seed);
    constexpr double kFastest = 60.0 / 60.0; // per second
    constexpr double kLargest = 2000.0;      // ml
    constexpr double kShortest = 0.1;        // of the breath, in or out
    const double steepestIn = std::numbers::pi / 2.0;
    const double steepestOut = kExpiratoryDecay / (1.0 - std::exp(-kExpiratoryDecay));
    const double maxFlow = kLargest * kFastest * std::max(steepestIn, steepestOut) / kShortest;

    std::mt19937 random{seed};
    std::uniform_real_distribution<double> share{0.0, 1.0};
    BreathingTimeline timeline;
    timeline.setRunning(atSeconds(0.0), true);
    constexpr double kSeconds = 60.0;
    for (int i = 0; i < 100; ++i) {
        timeline.setRate(atSeconds(kSeconds * share(random)),
                         perMinute(4.0 + 56.0 * share(random)));
        timeline.setTidalVolume(atSeconds(kSeconds * share(random)),
                                millilitres(20.0 + 1980.0 * share(random)));
        timeline.setInspiratoryFraction(atSeconds(kSeconds * share(random)),
                                        0.1 + 0.8 * share(random));
        timeline.setRunning(atSeconds(kSeconds * share(random)), i % 3 != 0);
    }
    constexpr double kStep = 0.5e-3;
    double last = inspiredMl(timeline, 0.0);
    double largest = 0.0;
    for (double seconds = kStep; seconds < kSeconds; seconds += kStep) {
        const double now = inspiredMl(timeline, seconds);
        COMPARE_WITHIN(now, last, maxFlow * kStep * 1.001);
        QVERIFY(now >= 0.0);
        last = now;
        largest = std::max(largest, now);
    }
    QVERIFY(largest > 20.0);
}

/// The same changes, given in order and shuffled, against a sum over pieces made here.
void TestBreathingTimeline::agreesWithPlainSummationWhateverTheOrder()
{
    struct Change {
        double seconds;
        double perMin; // negative: pause; zero: go on
    };
    std::mt19937 random{5};
    std::vector<Change> changes;
    for (int i = 0; i < 300; ++i) {
        const double kinds[] = {-1.0, 0.0, 4.0 + double(random() % 57),
                                4.0 + double(random() % 57)};
        changes.push_back({0.25 * i, kinds[random() % 4]});
    }
    std::vector<Change> shuffled = changes;
    std::ranges::shuffle(shuffled, random);
    BreathingTimeline timeline;
    for (const Change& change : shuffled) {
        if (change.perMin > 0.0)
            timeline.setRate(atSeconds(change.seconds), perMinute(change.perMin));
        else
            timeline.setRunning(atSeconds(change.seconds), change.perMin == 0.0);
    }
    double rate = BreathingPattern{}.rate.si;
    bool running = false;
    double breaths = 0.0;
    for (const Change& change : changes) {
        COMPARE_WITHIN(timeline.breathsAt(atSeconds(change.seconds)), breaths, kBreathTolerance);
        if (change.perMin > 0.0)
            rate = change.perMin / 60.0;
        else
            running = change.perMin == 0.0;
        breaths += running ? rate * 0.25 : 0.0;
    }
}

void TestBreathingTimeline::keepsTheLaterOfTwoForOneTime()
{
    BreathingTimeline timeline = fourSecondBreaths();
    timeline.setRate(atSeconds(4.0), perMinute(60.0));
    timeline.setRate(atSeconds(8.0), perMinute(15.0));
    timeline.setRate(atSeconds(4.0), perMinute(30.0));
    COMPARE_WITHIN(timeline.breathsAt(atSeconds(8.0)), 3.0, kBreathTolerance);
    COMPARE_WITHIN(timeline.breathsAt(atSeconds(12.0)), 4.0, kBreathTolerance);
}

void TestBreathingTimeline::takesTenThousandChanges()
{
    constexpr int kChanges = 10000;
    BreathingTimeline timeline;
    timeline.setRunning(atSeconds(0.0), true);
    for (int i = 0; i < kChanges; ++i) { // 12 and 36 per minute in turn, a second each
        timeline.setRate(atSeconds(i), perMinute(i % 2 == 0 ? 12.0 : 36.0));
        timeline.setTidalVolume(atSeconds(i), millilitres(300.0));
    }
    for (int i = 0; i < kChanges; i += 2)
        COMPARE_WITHIN(timeline.breathsAt(atSeconds(i)), i / 2 * 0.8, kBreathTolerance);
    double largest = 0.0;
    for (double seconds = 9000.0; seconds < 9100.0; seconds += 0.01)
        largest = std::max(largest, inspiredMl(timeline, seconds));
    COMPARE_WITHIN(largest, 300.0, 0.1); // sampled every 10 ms
}

} // namespace carina

QTEST_APPLESS_MAIN(carina::TestBreathingTimeline)
#include "tst_breathing_timeline.moc"
