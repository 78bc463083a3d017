#include "evaluation/network/virtual_star.h"
#include "tests/support/test_class.h"

namespace carina::virtual_star_test
{
namespace
{

using namespace std::chrono_literals;

DriftScenario steady(Duration forward, Duration backward)
{
    DriftScenario scenario;
    scenario.forward.delay = forward;
    scenario.backward.delay = backward;
    return scenario;
}

VirtualStar starOf(const char* strategy, const DriftScenario& scenario,
                   VirtualStar::Legs legs = VirtualStar::Legs::HalfPath, std::uint64_t seed = 1)
{
    return VirtualStar{*findSyncStrategy(strategy), 3, scenario, legs, seed, -10s};
}

EventCpo moving()
{
    EventCpo event;
    event.object = ObjectId{1};
    event.action = 1;
    event.kind = ActionKind::Translation;
    event.rate = 1.0F; // m/s along x
    return event;
}

double xAt(const VirtualStar& star, std::uint16_t id, Duration t)
{
    const auto shown = star.shown(id, ObjectId{1}, t);
    return shown ? shown->acted.X_AO.translation().x() : -1.0;
}

} // namespace

class VirtualStarTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void pathFromActorToViewerHasTheScenariosDelay_data()
    {
        QTest::addColumn<bool>("isFull");
        QTest::addColumn<double>("delay_s");
        QTest::newRow("half of it on each leg") << false << 0.030;
        QTest::newRow("all of it on each leg") << true << 0.060;
    }
    void pathFromActorToViewerHasTheScenariosDelay()
    {
        QFETCH(bool, isFull);
        QFETCH(double, delay_s);
        const auto legs = isFull ? VirtualStar::Legs::FullPath : VirtualStar::Legs::HalfPath;
        VirtualStar star = starOf("event", steady(30ms, 70ms), legs);
        QCOMPARE(toSeconds(star.leastDelay(2, 0s)), delay_s);
        star.act(moving(), 0s);
        const Duration arrival = fromSeconds(delay_s);
        star.runTo(arrival - 1ns);
        QCOMPARE(xAt(star, 2, arrival - 1ns), -1.0);
        star.runTo(1s);
        for (const std::uint16_t viewer : {std::uint16_t{2}, std::uint16_t{3}})
            QVERIFY(std::abs(xAt(star, viewer, 1s) - (1.0 - delay_s)) < 1e-3);
        QVERIFY(std::abs(xAt(star, 1, 1s) - 1.0) < 1e-3);
    }

    void lopsidedPathIsLopsidedAtBothEnds()
    {
        // 30 ms forth and 70 ms back put each clock 10 ms off, in opposite directions.
        VirtualStar star = starOf("session-clock", steady(30ms, 70ms));
        star.runTo(0s);
        QVERIFY(std::chrono::abs(*star.clockError(1, 0s) + 10ms) < 20us);
        QVERIFY(std::chrono::abs(*star.clockError(2, 0s) - 10ms) < 20us);
        QVERIFY(!starOf("event", steady(30ms, 70ms)).clockError(1, 0s));
    }

    void clocksAreOffAsTheScenarioSays()
    {
        DriftScenario scenario = steady(10ms, 10ms);
        scenario.clockOffset = 250ms;
        scenario.areClocksAtLimits = true;
        VirtualStar star = starOf("session-clock", scenario);
        star.runTo(60s);
        // Found and held all the same.
        for (const std::uint16_t id : {std::uint16_t{1}, std::uint16_t{2}, std::uint16_t{3}})
            QVERIFY(std::chrono::abs(*star.clockError(id, 60s)) < 1us);
    }

    void leastDelayTriesALossAgain()
    {
        DriftScenario scenario = steady(20ms, 20ms);
        scenario.forward.cutFrom = 5s;
        scenario.forward.cutFor = 35ms;
        VirtualStar star = starOf("event", scenario);
        QCOMPARE(star.leastDelay(2, 5s - 11ms), Duration{20ms});
        QCOMPARE(star.leastDelay(2, 5s - 10ms), Duration{20ms + 40ms}); // in the second leg
        QCOMPARE(star.leastDelay(2, 5s), Duration{20ms + 40ms});
        QCOMPARE(star.leastDelay(2, 5s + 35ms), Duration{20ms});
        scenario.forward.cutFor = 1h;
        VirtualStar cut = starOf("event", scenario);
        QVERIFY(cut.leastDelay(2, 5s) >= VirtualStar::kOracleGivesUp);
    }

    void countsBytesAndProbes()
    {
        // Each of three probes both others once a second: 13 bytes there and back over two legs.
        VirtualStar star = starOf("asa-fixed", steady(10ms, 10ms));
        star.runTo(-1ns);
        const auto before = star.traffic();
        star.runTo(10s - 1ns);
        const auto after = star.traffic();
        QCOMPARE(after.probes - before.probes, 60U);
        QVERIFY(std::abs(double(after.bytes - before.bytes) - 60.0 * 4 * 13) <= 2 * 13);
    }

    void sameSeedSameSession()
    {
        DriftScenario scenario = *findScenario("wifi");
        const auto bytesOf = [&](std::uint64_t seed) {
            VirtualStar star = starOf("session-clock", scenario, VirtualStar::Legs::HalfPath, seed);
            star.act(moving(), 0s);
            star.runTo(20s);
            return std::pair{star.traffic().bytes, xAt(star, 2, 20s)};
        };
        QCOMPARE(bytesOf(1), bytesOf(1));
        QVERIFY(bytesOf(1) != bytesOf(2));
    }
};

CARINA_TEST(VirtualStarTest)

} // namespace carina::virtual_star_test

#include "tst_virtual_star.moc"
