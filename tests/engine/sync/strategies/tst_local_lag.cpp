#include "tests/engine/sync/strategies/strategy_star.h"
#include "tests/support/test_class.h"

namespace carina::local_lag_test
{
namespace
{

using namespace std::chrono_literals;
using test::quarterTurns;
using test::StrategyStar;
using test::turnedAboutZ_deg;

constexpr ObjectId kObject{1};
constexpr double kDegreesPerSecond = 90.0;
constexpr double kTolerance_deg = 1e-4;

double drawn(const StrategyStar& star, std::uint16_t id)
{
    return turnedAboutZ_deg(star.shown(id, kObject));
}

} // namespace

/// With all clocks right, so that the views differ by nothing but when actions arrive.
class TestLocalLag : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void allViewsChangeAtOnce()
    {
        StrategyStar star{"local-lag", 3, {.toHost = 5ms, .fromHost = 5ms}};
        star.setLegs(3, {.toHost = 2ms, .fromHost = 2ms});
        star.act(1, quarterTurns(1));
        star.runTo(5s);
        star.act(1, quarterTurns(2));
        for (Duration t = 5s; t < 5s + 100ms; t += 1ms) {
            star.runTo(t);
            QVERIFY(std::abs(drawn(star, 2) - drawn(star, 1)) < kTolerance_deg);
            QVERIFY(std::abs(drawn(star, 3) - drawn(star, 1)) < kTolerance_deg);
        }
    }

    /// The way to the host, from it to the farthest, and the margin: 12 ms.
    void waitsNoLongerThanItMust()
    {
        StrategyStar star{"local-lag", 2, {.toHost = 5ms, .fromHost = 5ms}};
        star.runTo(5s);
        star.act(1, quarterTurns(1));
        star.runTo(5s + 11ms);
        QVERIFY(std::abs(drawn(star, 1)) < kTolerance_deg);
        star.runTo(5s + 112ms);
        QVERIFY(std::abs(drawn(star, 1) - kDegreesPerSecond * 0.1) < kTolerance_deg);
    }

    void waitsNoLongerThanItsBound()
    {
        StrategyStar star{"local-lag", 2, {.toHost = 30ms, .fromHost = 30ms}};
        star.runTo(5s);
        star.act(1, quarterTurns(1));
        star.runTo(5s + 116ms);
        QVERIFY(std::abs(drawn(star, 1) - kDegreesPerSecond * 0.1) < kTolerance_deg);
        QVERIFY(std::abs(drawn(star, 2) - drawn(star, 1)) < kTolerance_deg);
    }
};

CARINA_TEST(TestLocalLag)

} // namespace carina::local_lag_test

#include "tst_local_lag.moc"
