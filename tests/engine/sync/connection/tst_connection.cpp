#include "tests/engine/sync/connection/session_world.h"
#include "tests/support/test_class.h"

namespace carina::connection_test
{
namespace
{

using namespace std::chrono_literals;

const SimulatedLink::Path kCalm{5ms, 0ms, 0.0, 0.0};

std::ptrdiff_t joinsOf(const std::vector<FactRecord>& log, const std::string& name)
{
    return std::ranges::count(log, TestSession::body(std::string{"J"}.append(name)),
                              &FactRecord::body);
}

} // namespace

class TestConnection : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void hostBackOnItsAddressIsFoundWithinHalfASecond()
    {
        SessionWorld world{5};
        world.addSite(kCalm);
        world.startClient(0, "anna");
        world.run(20s);
        // Away for long, so that the client has backed off as far as it does.
        world.crashHost();
        world.run(20s);
        QCOMPARE(world.site(0).client->state(), SyncClient::State::Away);
        world.startHost();
        world.run(SyncClient::kLastHelloWait + 4 * kCalm.delay);
        QCOMPARE(world.site(0).client->state(), SyncClient::State::Connected);
        // Away for a moment: the next datagram is answered with "unknown connection".
        world.crashHost();
        world.run(1s);
        QCOMPARE(world.site(0).client->state(), SyncClient::State::Connected);
        world.startHost();
        world.run(kKeepAlive + 6 * kCalm.delay);
        QCOMPARE(world.site(0).client->state(), SyncClient::State::Connected);
        QCOMPARE(world.host().peers().size(), std::size_t{1});
        // The same run of the program: it did not come in a second time.
        QCOMPARE(joinsOf(world.session.disk, "anna"), std::ptrdiff_t{1});
    }

    void goodbyeOfTheHostIsNoticedAtOnce()
    {
        SessionWorld world{6};
        world.addSite(kCalm);
        world.startClient(0, "anna");
        world.run(1s);
        world.host().close(world.hostTime());
        const auto farewell = world.host().take();
        world.crashHost();
        QCOMPARE(farewell.datagrams.size(), std::size_t{1});
        world.site(0).fromHost.send(farewell.datagrams[0].bytes, world.now());
        world.run(6ms);
        QCOMPARE(world.site(0).client->state(), SyncClient::State::Away);
    }

    void silentClientIsGoneAfterThreeSeconds()
    {
        SessionWorld world{7};
        world.addSite(kCalm);
        world.startClient(0, "anna");
        world.run(1s);
        const LocalTime lastWord = world.host().peers().begin()->second.link.lastHeard();
        world.crashClient(0);
        world.run(5s);
        QVERIFY(world.host().peers().empty());
        QCOMPARE(world.session.departures.size(), std::size_t{1});
        QCOMPARE(world.session.departures[0].first, ParticipantId{1});
        const Duration after = world.session.departures[0].second - lastWord;
        QVERIFY(after >= 3s);
        QVERIFY(after <= 3s + kKeepAlive + 10ms);
        QVERIFY(world.session.reasons == std::vector{Leave::Silence});
    }

    void clientThatLeavesIsGoneAtOnce()
    {
        SessionWorld world{8};
        world.addSite(kCalm);
        world.startClient(0, "anna");
        world.run(1s);
        auto& site = world.site(0);
        site.client->leave(site.clock.at(world.now()));
        world.run(6ms);
        QVERIFY(world.host().peers().empty());
        QCOMPARE(world.session.departures.size(), std::size_t{1});
        QVERIFY(world.session.reasons == std::vector{Leave::Meant});
        QCOMPARE(site.client->state(), SyncClient::State::Closed);
        QCOMPARE(site.client->nextWake(), LocalTime::max());
    }

    void restartedClientIsTheSameParticipant()
    {
        SessionWorld world{9};
        world.addSite(kCalm);
        world.addSite(kCalm);
        world.startClient(0, "anna");
        world.run(1s);
        world.propose(0, "before the crash");
        world.run(1s);
        const std::uint16_t epochBefore = world.host().peers().begin()->second.epoch;
        world.crashClient(0);
        world.startClient(1, "anna"); // another port
        world.run(1s);
        QCOMPARE(world.site(1).client->self(), ParticipantId{1});
        QVERIFY(world.site(1).log == world.session.disk);
        QCOMPARE(joinsOf(world.session.disk, "anna"), std::ptrdiff_t{2});
        QCOMPARE(world.host().peers().size(), std::size_t{1});
        QVERIFY(world.host().peers().begin()->second.epoch > epochBefore);
        QVERIFY(world.session.departures.empty());
    }

    void restartedClientOnItsOldPortIsTheSameParticipant()
    {
        SessionWorld world{10};
        world.addSite(kCalm);
        world.startClient(0, "anna");
        world.run(1s);
        world.startClient(0, "anna");
        world.run(100ms);
        QCOMPARE(world.site(0).client->state(), SyncClient::State::Connected);
        QCOMPARE(world.site(0).client->self(), ParticipantId{1});
        QVERIFY(world.site(0).log == world.session.disk);
    }

    void anotherProgramOnTheOldPortIsAnotherParticipant()
    {
        SessionWorld world{11};
        world.addSite(kCalm);
        world.startClient(0, "anna");
        world.run(1s);
        world.startClient(0, "ben");
        world.run(1s);
        QCOMPARE(world.site(0).client->self(), ParticipantId{2});
        QCOMPARE(world.session.departures.size(), std::size_t{1});
        QCOMPARE(world.session.departures[0].first, ParticipantId{1});
        QCOMPARE(world.host().peers().size(), std::size_t{1});
    }

    void secondProgramOfOneNameIsRefusedWhileTheFirstLives()
    {
        SessionWorld world{12};
        world.session.areProven = false;
        world.addSite(kCalm);
        world.addSite(kCalm);
        world.startClient(0, "anna");
        world.run(1s);
        world.startClient(1, "anna");
        world.run(5s);
        QCOMPARE(world.site(0).client->state(), SyncClient::State::Connected);
        QCOMPARE(world.site(1).client->state(), SyncClient::State::Connecting);
        QCOMPARE(world.site(1).client->helloRefused()->code, Errc::NameTaken);
        world.crashClient(0);
        world.run(SyncHost::kNameHeld + SyncClient::kLastHelloWait + 20ms);
        QCOMPARE(world.site(1).client->state(), SyncClient::State::Connected);
        QVERIFY(!world.site(1).client->helloRefused());
    }

    void refusedJoinSaysWhy()
    {
        SessionWorld world{13};
        world.addSite(kCalm);
        auto& site = world.site(0);
        site.client = std::make_unique<SyncClient>(world.proposal("not a join"), 1U, LocalTime{});
        world.run(1s);
        QCOMPARE(site.client->state(), SyncClient::State::Connecting);
        QCOMPARE(site.client->helloRefused()->code, Errc::NotPermitted);
        QVERIFY(world.session.disk.empty());
    }

    void idlePeersSendFourDatagramsASecond()
    {
        SessionWorld world{18};
        world.addSite(kCalm);
        world.startClient(0, "anna");
        world.run(10s);
        const std::size_t before = world.site(0).toHost.sent();
        const std::size_t beforeBack = world.site(0).fromHost.sent();
        world.run(60s);
        const std::size_t out = world.site(0).toHost.sent() - before;
        const std::size_t back = world.site(0).fromHost.sent() - beforeBack;
        QVERIFY(out >= 239 && out <= 241);
        QVERIFY(back >= 239 && back <= 241);
    }
};

CARINA_TEST(TestConnection)

} // namespace carina::connection_test

#include "tst_connection.moc"
