#include "engine/sync/strategies/action_meter.h"
#include "tests/support/test_class.h"

#include <cmath>

namespace carina::action_meter_test
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
        const ActionFigures figures = ActionMeter{}.figures();
        QCOMPARE(figures.limit.rotation.si, 0.0);
        QCOMPARE(figures.delay, Duration{});
    }

    void limitIsTheChangeOfVelocityTimesTheDelay()
    {
        ActionMeter meter;
        meter.arrived(turnAt(kBegin, 2.0F), turnAt(kBegin, 0.5F), kBegin + 40ms);
        const ActionFigures& figures = meter.figures();
        QVERIFY(isNear(figures.limit.rotation.si, 1.5 * 0.040));
        QVERIFY(isNear(figures.limit.position.si, 0.0));
        QCOMPARE(figures.delay, Duration{40ms});
    }

    void whoPutsAnObjectElsewhereHasNoLimit()
    {
        EventCpo away = turnAt(kBegin - 1s, 0.0F);
        away.p_AO = Vec3{0.5, 0.0, 0.0};
        ActionMeter meter;
        meter.arrived(turnAt(kBegin, 0.0F), away, kBegin);
        QCOMPARE(meter.figures().limit.position.si, 0.0);
    }

    void limitOfATranslationIsADistance()
    {
        EventCpo push = turnAt(kBegin, 0.25F);
        push.kind = ActionKind::Translation;
        ActionMeter meter;
        meter.arrived(push, turnAt(kBegin, 0.0F), kBegin + 100ms);
        const ActionFigures& figures = meter.figures();
        QVERIFY(isNear(figures.limit.position.si, 0.025));
        QVERIFY(isNear(figures.limit.rotation.si, 0.0));
    }

    void limitOfAScalingIsARatio()
    {
        EventCpo growth = turnAt(kBegin, 0.5F);
        growth.kind = ActionKind::Scaling;
        ActionMeter meter;
        meter.arrived(growth, turnAt(kBegin, 0.0F), kBegin + 100ms);
        QVERIFY(isNear(meter.figures().limit.scale, std::exp(0.05) - 1.0));
        QVERIFY(isNear(meter.limitAt(kBegin + 50ms).scale, std::exp(0.05) - 1.0));
        QVERIFY(isNear(meter.figures().limit.rotation.si, 0.0));
    }

    void limitIsOfTheShortestDelay()
    {
        ActionMeter meter;
        meter.arrived(turnAt(kBegin, 1.0F), turnAt(kBegin, 0.0F), kBegin + 20ms);
        meter.arrived(turnAt(kBegin + 1s, 1.0F), turnAt(kBegin + 1s, 0.0F), kBegin + 1s + 50ms);
        const ActionFigures& figures = meter.figures();
        QVERIFY(isNear(figures.limit.rotation.si, 0.020));
        QCOMPARE(figures.delay, Duration{50ms});
    }

    void anotherOwnersDelayIsNoLimit()
    {
        ActionMeter meter;
        meter.arrived(turnAt(kBegin, 1.0F, 1), turnAt(kBegin, 0.0F), kBegin + 20ms);
        meter.arrived(turnAt(kBegin + 1s, 1.0F, 2), turnAt(kBegin + 1s, 0.0F), kBegin + 1s + 50ms);
        QVERIFY(isNear(meter.figures().limit.rotation.si, 0.050));
    }

    void delaysOfLongAgoAreNoLimit()
    {
        ActionMeter meter;
        meter.arrived(turnAt(kBegin, 1.0F), turnAt(kBegin, 0.0F), kBegin + 20ms);
        const SessionTime edge = kBegin + 20ms + ActionMeter::kWindow; // exactly as old
        meter.arrived(turnAt(edge - 50ms, 1.0F), turnAt(edge - 50ms, 0.0F), edge);
        QVERIFY(isNear(meter.figures().limit.rotation.si, 0.020));
        const SessionTime after = edge + 1ns;
        meter.arrived(turnAt(after - 70ms, 1.0F), turnAt(after - 70ms, 0.0F), after);
        QVERIFY(isNear(meter.figures().limit.rotation.si, 0.050));
    }

    void clockThatIsAheadGivesNoNegativeDelay()
    {
        ActionMeter meter;
        meter.arrived(turnAt(kBegin, 1.0F), turnAt(kBegin, 0.0F), kBegin - 1ms);
        QCOMPARE(meter.figures().delay, Duration{});
        QCOMPARE(meter.figures().limit.rotation.si, 0.0);
    }

    /// Once everybody has an action, nothing keeps views of it apart.
    void limitHoldsWhileAnActionIsUnderWay()
    {
        ActionMeter meter;
        meter.arrived(turnAt(kBegin, 2.0F), turnAt(kBegin, 0.0F), kBegin + 40ms);
        meter.arrived(turnAt(kBegin + 30ms, 1.0F), turnAt(kBegin + 30ms, 2.0F), kBegin + 70ms);
        QCOMPARE(meter.limitAt(kBegin - 1ns).rotation.si, 0.0);
        QVERIFY(isNear(meter.limitAt(kBegin).rotation.si, 2.0 * 0.040));
        QVERIFY(isNear(meter.limitAt(kBegin + 35ms).rotation.si, 2.0 * 0.040)); // both
        QVERIFY(isNear(meter.limitAt(kBegin + 40ms).rotation.si, 1.0 * 0.040));
        QCOMPARE(meter.limitAt(kBegin + 70ms).rotation.si, 0.0);
    }

    void forgetsAllButTheLastHundredDelays()
    {
        ActionMeter meter;
        meter.arrived(turnAt(kBegin, 1.0F), turnAt(kBegin, 0.0F), kBegin + 20ms);
        for (int i = 1; i <= 100; ++i) {
            const SessionTime t = kBegin + i * 10ms;
            QVERIFY(isNear(meter.figures().limit.rotation.si, 0.020));
            meter.arrived(turnAt(t, 1.0F), turnAt(t, 0.0F), t + 50ms);
        }
        QVERIFY(isNear(meter.figures().limit.rotation.si, 0.050));
    }
};

CARINA_TEST(TestActionMeter)

} // namespace carina::action_meter_test

#include "tst_action_meter.moc"
