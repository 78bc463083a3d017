#include "tests/engine/sync/connection/session_world.h"
#include "tests/support/test_class.h"

namespace carina::client_clock_test
{

using namespace std::chrono_literals;

class TestClientClock : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void lostHostIsFoundAgainWithTheSameClock()
    {
        SessionWorld world{23};
        auto& site = world.site(world.addSite({5ms, 1ms, 0.0, 0.0}, {-250ms, 50}));
        world.startClient(0, "anna");
        world.run(30s);
        world.crashHost();
        world.run(10s);
        world.startHost();
        world.run(2s);
        QVERIFY(!site.client->clock().isAcquiring());
        const LocalTime local = site.clock.at(world.now());
        QVERIFY(
            std::chrono::abs(site.client->clock().mapping()->at(local) - world.trueSessionTime())
            < 1ms);
    }

    void disciplinedClocksAtBothEndsSeeAnAsymmetricPath()
    {
        SessionWorld world{29};
        auto& site = world.site(world.addSite({25ms, 0ms, 0.0, 0.0}, {-250ms, 50}));
        site.fromHost.setPath({55ms, 0ms, 0.0, 0.0});
        world.startClient(0, "anna");
        const auto error = [&] {
            const LocalTime local = site.clock.at(world.now());
            return site.client->clock().mapping()->at(local) - world.trueSessionTime();
        };
        world.run(60s);
        QVERIFY(std::chrono::abs(std::chrono::abs(error()) - 15ms) < 100us); // half of 30
        QVERIFY(!site.client->clock().external());
        const auto readTrueTime = [&] {
            const Duration truth = 400'000h + world.now();
            const LocalTime local = site.clock.at(world.now());
            const LocalTime atHost = world.hostTime();
            world.host().readExternal({truth - atHost.time_since_epoch(), 1ms}, atHost);
            site.client->readExternal({truth - local.time_since_epoch(), 1ms}, local);
        };
        world.run(60s, 1s, readTrueTime);
        QVERIFY(std::chrono::abs(error()) < 200us);
        QVERIFY(!site.client->clock().external()->isRefused);
        // The host sees the same of the participant's clock.
        const PeerClock& seen = world.host().peers().begin()->second.clock;
        QVERIFY(seen.external().has_value());
        QVERIFY(std::chrono::abs(std::chrono::abs(seen.external()->difference) - 15ms) < 200us);
    }

    void readingsThatEndAtOneEndNoLongerCount_data()
    {
        QTest::addColumn<bool>("ofTheHost");
        QTest::newRow("of the participant") << false;
        QTest::newRow("of the host") << true;
    }

    void readingsThatEndAtOneEndNoLongerCount()
    {
        QFETCH(bool, ofTheHost);
        SessionWorld world{29};
        auto& site = world.site(world.addSite({25ms, 0ms, 0.0, 0.0}, {-250ms, 50}));
        site.fromHost.setPath({55ms, 0ms, 0.0, 0.0});
        world.startClient(0, "anna");
        bool end = false;
        const auto readTrueTime = [&] {
            const Duration truth = 400'000h + world.now();
            const LocalTime local = site.clock.at(world.now());
            const LocalTime atHost = world.hostTime();
            if (!end || !ofTheHost)
                world.host().readExternal({truth - atHost.time_since_epoch(), 1ms}, atHost);
            if (!end || ofTheHost)
                site.client->readExternal({truth - local.time_since_epoch(), 1ms}, local);
        };
        const auto seenByHost = [&] {
            return world.host().peers().begin()->second.clock.external();
        };
        world.run(60s, 1s, readTrueTime);
        QVERIFY(site.client->clock().external());
        QVERIFY(seenByHost());
        end = true;
        world.run(FittedClock::kExternalTime + 5s, 1s, readTrueTime);
        QVERIFY(!site.client->clock().external());
        QVERIFY(!seenByHost());
    }

    void oneSlowDatagramIsNoOtherRouteHoweverOftenItIsAnswered()
    {
        constexpr ObjectId kJaw{2};
        constexpr Duration kSlow = 25ms;
        SessionWorld world{31};
        auto& site = world.site(world.addSite({5ms, 0ms, 0.0, 0.0}));
        world.startClient(0, "anna");
        world.host().share(kJaw, {ParticipantId{0}, 1});
        StreamSample sample{ParticipantId{0}, 1, StationId{}, {}};
        sample.cpo.object = kJaw;
        const auto stream = [&] { // 60 answers a second, a dozen to each datagram of the client's
            ++sample.cpo.sequence;
            sample.cpo.time = world.trueSessionTime();
            world.host().publish(sample, world.hostTime());
        };
        world.run(10s, StreamTick::kPeriod, stream);
        const auto path = site.toHost.path();
        site.toHost.setPath({kSlow, 0ms, 0.0, 0.0});
        const std::size_t sent = site.toHost.sent();
        world.run(2s, StreamTick::kPeriod, [&] {
            stream();
            if (site.toHost.sent() > sent)
                site.toHost.setPath(path);
        });
        const auto& delays = site.client->clock().trigger().history().delays();
        const auto isSlow = [](Duration delay) { return delay > 10ms; };
        QCOMPARE(std::ranges::count_if(delays, isSlow), std::ptrdiff_t{1});
        QVERIFY(std::cmp_less_equal(delays.size(), site.toHost.sent()));
    }

    void staysWithinHalfTheRoundTripUnderJitter_data()
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

    void staysWithinHalfTheRoundTripUnderJitter()
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
        world.run(300s, 10ms, [&] {
            const auto& mapping = site.client->clock().mapping();
            if (!mapping)
                return;
            const LocalTime local = site.clock.at(world.now());
            const SessionTime now = mapping->at(local);
            monotone = monotone && (!last || now > *last);
            last = now;
            const Duration error = std::chrono::abs(now - world.trueSessionTime());
            if (world.now() > 60s)
                worst = std::max(worst, error);
        });
        QVERIFY(monotone);
        // Once settled: within half of the shortest round trip there is.
        QVERIFY2(worst <= std::chrono::microseconds{delayUs},
                 std::to_string(toSeconds(worst) * 1e3).c_str());
    }
};

CARINA_TEST(TestClientClock)

} // namespace carina::client_clock_test

#include "tst_client_clock.moc"
