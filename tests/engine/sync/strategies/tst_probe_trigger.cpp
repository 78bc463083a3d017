#include "engine/sync/strategies/probe_trigger.h"
#include "tests/support/test_class.h"

namespace carina::probe_trigger_test
{
namespace
{

using namespace std::chrono_literals;

/// A history of `fill` delays that alternate between 19 and 21 ms: mean 20 ms, sigma 1 ms.
ProbeTrigger filled(ProbeTrigger::Rule rule = {}, int fill = 100)
{
    ProbeTrigger trigger{rule};
    for (int i = 0; i < fill; ++i)
        trigger.addDelay(i % 2 == 0 ? 19ms : 21ms);
    return trigger;
}

} // namespace

class TestProbeTrigger : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void probesOnceASecondWhileTheHistoryFills()
    {
        ProbeTrigger trigger = filled({}, 98);
        trigger.addDelay(500ms);
        QCOMPARE(trigger.rate(), 1.0);
        QCOMPARE(trigger.interval(), Duration{1s});
        trigger.addDelay(500ms); // the hundredth, and outside
        QCOMPARE(trigger.rate(), 2.0);
        QCOMPARE(trigger.interval(), Duration{500ms});
    }

    void fixedTriggerNeverAdapts()
    {
        ProbeTrigger trigger = filled({.isAdaptive = false});
        for (int i = 0; i < 50; ++i)
            trigger.addDelay(500ms);
        QCOMPARE(trigger.rate(), 1.0);
    }

    void delayOutsideOneSigmaRaisesTheRateByOne()
    {
        ProbeTrigger trigger = filled();
        trigger.addDelay(30ms);
        QCOMPARE(trigger.rate(), 2.0);
        trigger.addDelay(10ms);
        QCOMPARE(trigger.rate(), 3.0);
    }

    void delayInsideOneSigmaLowersTheRateByOne()
    {
        ProbeTrigger trigger = filled();
        trigger.addDelay(30ms);
        trigger.addDelay(30ms);
        trigger.addDelay(20ms);
        QCOMPARE(trigger.rate(), 2.0);
    }

    void rateStaysWithinItsBounds()
    {
        ProbeTrigger trigger = filled({.lowest = 1.0, .highest = 3.0});
        for (const Duration delay : {40ms, 60ms, 80ms, 100ms, 120ms})
            trigger.addDelay(delay);
        QCOMPARE(trigger.rate(), 3.0);
        for (int i = 0; i < 5; ++i)
            trigger.addDelay(20ms);
        QCOMPARE(trigger.rate(), 1.0);
    }

    void publishedBoundsAreOneAndTwenty()
    {
        QCOMPARE(ProbeTrigger::Rule{}.lowest, 1.0);
        QCOMPARE(ProbeTrigger::Rule{}.highest, 20.0);
        QCOMPARE(ProbeTrigger::Rule{}.start, 1.0);
        QCOMPARE(ProbeTrigger::Rule{}.history, 100U);
    }

    void delayOnTheEdgeIsInside()
    {
        const ProbeTrigger trigger = filled();
        QVERIFY(!trigger.isOutside(21ms, 1));
        QVERIFY(!trigger.isOutside(19ms, 1));
        QVERIFY(trigger.isOutside(21ms + 1ns, 1));
        QVERIFY(trigger.isOutside(19ms - 1ns, 1));
        QVERIFY(!trigger.isOutside(24ms - 1ns, 4));
        QVERIFY(trigger.isOutside(24ms + 1ns, 4));
    }

    void equalDelaysAreInside()
    {
        ProbeTrigger trigger{{.start = 5.0}};
        for (int i = 0; i < 102; ++i)
            trigger.addDelay(20ms);
        QCOMPARE(trigger.rate(), 2.0);
    }

    void sigmaFloorForgivesSmallScatter()
    {
        ProbeTrigger strict{{.start = 5.0}};
        ProbeTrigger lenient{{.start = 5.0, .sigmaFloor = 100us}};
        for (int i = 0; i < 100; ++i) {
            const Duration delay = i == 99 ? 20ms + 90us : 20ms;
            strict.addDelay(delay);
            lenient.addDelay(delay);
        }
        QCOMPARE(strict.rate(), 6.0);
        QCOMPARE(lenient.rate(), 4.0);
    }

    void resetBeginsAnew()
    {
        ProbeTrigger trigger = filled();
        trigger.addDelay(30ms);
        trigger.reset();
        QCOMPARE(trigger.rate(), 1.0);
        QCOMPARE(trigger.history().size(), 0U);
        trigger.addDelay(30ms);
        trigger.addDelay(90ms);
        QCOMPARE(trigger.rate(), 1.0);
    }
};

CARINA_TEST(TestProbeTrigger)

} // namespace carina::probe_trigger_test

#include "tst_probe_trigger.moc"
