#include "engine/sync/connection/peer_traffic.h"
#include "tests/engine/sync/connection/session_world.h"
#include "tests/support/test_class.h"

namespace carina::peer_traffic_test
{

using namespace std::chrono_literals;

/// What a participant sends, as the host counts it.
class TestPeerTraffic : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// 60 arrivals a second of 100 each are 6000 a second; the mean over the period between two.
    void steadyArrivalsAreShownInFull()
    {
        RateMeter meter;
        LocalTime now{100s};
        for (int i = 0; i < 600; ++i, now += 1'000'000'000ns / 60)
            meter.add(100.0, now);
        const double shown = meter.perSecond(now - 1'000'000'000ns / 120);
        QVERIFY2(std::abs(shown - 6000.0) < 60.0, qPrintable(QString::number(shown)));
    }

    void silenceIsForgotten()
    {
        RateMeter meter;
        const LocalTime now{100s};
        meter.add(100.0, now);
        QCOMPARE(meter.perSecond(now), 100.0);
        QVERIFY(std::abs(meter.perSecond(now + 1s) - 100.0 * std::exp(-1.0)) < 1e-9);
        QVERIFY(meter.perSecond(now + 10s) < 0.01);
        QCOMPARE(meter.perSecond(now - 1s), 100.0); // a clock that goes back is none
    }

    void factsAreCountedOnceAndRefusalsBeside()
    {
        SessionWorld world{35};
        world.addSite({150ms, 0ms, 0.0, 0.0}); // so that every proposal is repeated
        world.startClient(0, "anna");
        world.run(1s);
        for (int i = 0; i < 5; ++i)
            world.propose(0, "fact " + std::to_string(i));
        world.run(3s);
        QCOMPARE(world.host().peers().size(), std::size_t{1});
        const PeerTraffic& traffic = world.host().peers().begin()->second.traffic;
        QCOMPARE(traffic.facts, std::uint64_t{5});
        QCOMPARE(traffic.refused, std::uint64_t{0});
        QVERIFY(traffic.bytes.perSecond(world.hostTime()) > 50.0); // a header four times a second
        world.propose(0, "X refused");
        world.run(1s);
        QVERIFY(traffic.refused >= 1);
        QCOMPARE(traffic.facts, std::uint64_t{5});
    }
};

CARINA_TEST(TestPeerTraffic)

} // namespace carina::peer_traffic_test

#include "tst_peer_traffic.moc"
