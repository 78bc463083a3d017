#include "engine/sync/action_meter.h"

#include <QTest>

namespace carina
{
namespace
{

using namespace std::chrono_literals;

constexpr SessionTime kBegin{1000s};
constexpr double kTolerance = 1e-9;

/// A turn about z at so many rad/s, from the same pose as all others.
EventCpo turnAt(SessionTime start, float rate, std::uint16_t epoch = 1)
{
    EventCpo event;
    event.epoch = epoch;
    event.start = start;
    event.axis_A = Vec3f::UnitZ();
    event.rate = rate;
    return event;
}

bool isNear(double a, double b) { return std::abs(a - b) < kTolerance; }

} // namespace

class TestActionMeter : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void nothingCameYet()
    {
        const ActionFigures figures = ActionMeter{}.figures(kBegin);
        QCOMPARE(figures.drift.rotation.si, 0.0);
        QCOMPARE(figures.perSecond, 0.0);
        QCOMPARE(figures.delay, Duration{});
    }

    void driftIsTheChangeOfVelocityTimesTheDelay()
    {
        ActionMeter meter;
        meter.arrived(turnAt(kBegin, 2.0F), turnAt(kBegin, 0.5F), kBegin + 40ms);
        const ActionFigures figures = meter.figures(kBegin + 40ms);
        QVERIFY(isNear(figures.drift.rotation.si, 1.5 * 0.040));
        QVERIFY(isNear(figures.limit.rotation.si, 1.5 * 0.040));
        QVERIFY(isNear(figures.drift.position.si, 0.0));
        QCOMPARE(figures.delay, Duration{40ms});
    }

    void driftOfATranslationIsADistance()
    {
        EventCpo push = turnAt(kBegin, 0.25F);
        push.kind = ActionKind::Translation;
        ActionMeter meter;
        meter.arrived(push, turnAt(kBegin, 0.0F), kBegin + 100ms);
        const ActionFigures figures = meter.figures(kBegin + 100ms);
        QVERIFY(isNear(figures.drift.position.si, 0.025));
        QVERIFY(isNear(figures.drift.rotation.si, 0.0));
    }

    void limitIsOfTheShortestDelay()
    {
        ActionMeter meter;
        meter.arrived(turnAt(kBegin, 1.0F), turnAt(kBegin, 0.0F), kBegin + 20ms);
        meter.arrived(turnAt(kBegin + 1s, 1.0F), turnAt(kBegin + 1s, 0.0F), kBegin + 1s + 50ms);
        const ActionFigures figures = meter.figures(kBegin + 2s);
        QVERIFY(isNear(figures.drift.rotation.si, 0.050));
        QVERIFY(isNear(figures.limit.rotation.si, 0.020));
        QCOMPARE(figures.delay, Duration{50ms});
    }

    void anotherOwnersDelayIsNoLimit()
    {
        ActionMeter meter;
        meter.arrived(turnAt(kBegin, 1.0F, 1), turnAt(kBegin, 0.0F), kBegin + 20ms);
        meter.arrived(turnAt(kBegin + 1s, 1.0F, 2), turnAt(kBegin + 1s, 0.0F), kBegin + 1s + 50ms);
        QVERIFY(isNear(meter.figures(kBegin + 2s).limit.rotation.si, 0.050));
    }

    void delaysOfLongAgoAreNoLimit()
    {
        ActionMeter meter;
        meter.arrived(turnAt(kBegin, 1.0F), turnAt(kBegin, 0.0F), kBegin + 20ms);
        const SessionTime later = kBegin + ActionMeter::kWindow;
        meter.arrived(turnAt(later, 1.0F), turnAt(later, 0.0F), later + 20ms); // exactly as old
        QCOMPARE(meter.figures(later + 20ms).perSecond, 0.2);
        meter.arrived(turnAt(later, 1.0F), turnAt(later, 0.0F), later + 50ms);
        QVERIFY(isNear(meter.figures(later + 50ms).limit.rotation.si, 0.020));
        const SessionTime last = later + 2 * ActionMeter::kWindow;
        meter.arrived(turnAt(last, 1.0F), turnAt(last, 0.0F), last + 70ms);
        QVERIFY(isNear(meter.figures(last + 70ms).limit.rotation.si, 0.070));
    }

    void clockThatIsAheadGivesNoNegativeDelay()
    {
        ActionMeter meter;
        meter.arrived(turnAt(kBegin, 1.0F), turnAt(kBegin, 0.0F), kBegin - 1ms);
        QCOMPARE(meter.figures(kBegin).delay, Duration{});
        QCOMPARE(meter.figures(kBegin).drift.rotation.si, 0.0);
    }

    void countsActionsPerSecond()
    {
        ActionMeter meter;
        for (int i = 0; i < 40; ++i) { // 4 a second for 10 s
            const SessionTime t = kBegin + i * 250ms;
            meter.arrived(turnAt(t, 1.0F), turnAt(t, 0.0F), t);
        }
        const SessionTime end = kBegin + 39 * 250ms;
        QCOMPARE(meter.figures(end).perSecond, 4.0);
        QCOMPARE(meter.figures(end + ActionMeter::kWindow).perSecond, 0.1);
        QCOMPARE(meter.figures(end + ActionMeter::kWindow + 1ns).perSecond, 0.0);
    }

    void countsManyActionsPerSecond()
    {
        ActionMeter meter;
        SessionTime t = kBegin;
        for (int i = 0; i < 500; ++i, t += 20ms)
            meter.arrived(turnAt(t, 1.0F), turnAt(t, 0.0F), t);
        // The last 100 of 50 a second, counted when the next would come.
        QCOMPARE(meter.figures(t).perSecond, 50.0);
    }
};

} // namespace carina

QTEST_GUILESS_MAIN(carina::TestActionMeter)
#include "tst_action_meter.moc"
