#include "engine/net/entry/token_message.h"
#include "engine/net/node/client_driver.h"
#include "engine/session/facts/fact_codec.h"
#include "engine/session/participant_limits.h"
#include "tests/support/test_class.h"

namespace carina::client_driver_test
{
namespace
{

using namespace std::chrono_literals;

constexpr PeerAddress kClient = 1;
constexpr PeerAddress kHost = 2;

std::vector<FactRecord> logOf(const std::vector<FactBody>& bodies)
{
    std::vector<FactRecord> log;
    for (const FactBody& body : bodies) {
        Fact fact;
        fact.number = FactNumber{log.size() + 1};
        fact.proposal = ProposalId{log.size() + 1};
        fact.body = body;
        log.push_back(toRecord(fact));
    }
    return log;
}

/// A client's driver and a host's core, passing datagrams by hand every millisecond.
struct Pair {
    explicit Pair(std::vector<FactRecord> log, Role role = Role::Trainee)
        : host{SessionKey{std::byte{1}},
               log,
               1000h,
               {[](const Hello&, LocalTime) {
                    return Identity{ParticipantId{5}, true};
                },
                [log](const Hello&, LocalTime) {
                    return Admission{ParticipantId{5}, log.back().number};
                },
                [](ProposalId) { return false; },
                [](const ProposalRecord&, LocalTime) { return fail(Errc::NotPermitted); },
                [](ParticipantId, Leave, LocalTime) {}, [](ParticipantId) { return true; },
                [](ParticipantId) { return limitsOf(Role::Instructor); },
                [](ParticipantId) { return StationId{}; },
                [](PeerAddress) { return std::shared_ptr<SharedBudget>{}; }}},
          client{{0, "Anna", role}, board, now}
    {
        client.connected(kHost, {}, now);
    }
    void run(Duration length)
    {
        for (const LocalTime end = now + length; now < end; now += 1ms) {
            for (const auto& [to, bytes] : client.advance(now))
                host.receive(kClient, bytes, now);
            host.advance(now);
            for (const auto& [to, bytes] : host.take().datagrams)
                client.receive(kHost, bytes, now);
        }
    }

    LocalTime now{1s};
    NodeBoard board;
    SyncHost host;
    ClientDriver client;
};

} // namespace

class TestClientDriver : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void appliesTheLog()
    {
        Pair pair{logOf({fact::SessionCreated{"Course", "00ff"}, fact::StationAdded{"One"}})};
        QVERIFY(!pair.board.clock());
        pair.run(200ms);
        QCOMPARE(pair.board.state()->name(), std::string{"Course"});
        QCOMPARE(pair.board.part(&NodeBoard::View::self), ParticipantId{5});
        QCOMPARE(pair.board.part(&NodeBoard::View::links)->at(0).report.state,
                 LinkState::Connected);
        QCOMPARE(pair.board.clock()->at(pair.now), pair.host.sessionTime(pair.now));
    }

    void doesNotFollowALogThatNobodyCanHaveJudged()
    {
        auto log = logOf({fact::SessionCreated{"Course", "00ff"}, fact::StationAdded{"One"},
                          fact::StationAdded{"Two"}});
        log[1].body = {std::byte{0xFF}};
        Pair pair{log};
        pair.run(200ms);
        QCOMPARE(pair.board.part(&NodeBoard::View::refusal)->code, Errc::PacketMalformed);
        QCOMPARE(pair.board.state()->lastApplied(), FactNumber{1});
        QCOMPARE(pair.board.part(&NodeBoard::View::links)->at(0).report.state, LinkState::Ended);
        QVERIFY(pair.host.peers().empty()); // it said goodbye
    }

    void hearsOnlyItsHost()
    {
        Pair pair{logOf({fact::SessionCreated{"Course", "00ff"}})};
        for (const auto& [to, bytes] : pair.client.advance(pair.now))
            pair.host.receive(kClient, bytes, pair.now);
        pair.host.advance(pair.now);
        for (const auto& [to, bytes] : pair.host.take().datagrams)
            pair.client.receive(kHost + 1, bytes, pair.now);
        QVERIFY(pair.client.advance(pair.now).empty());
        QCOMPARE(pair.board.part(&NodeBoard::View::self), kNobody);
    }

    void refusedProposalIsShownUntilTheNext()
    {
        Pair pair{logOf({fact::SessionCreated{"Course", "00ff"}})};
        pair.run(100ms);
        const FactBody rate = fact::BreathingRateSet{perMinute(20.0)};
        pair.client.propose(StationId{}, rate, pair.now);
        static_cast<void>(pair.client.advance(pair.now)); // on its way
        QCOMPARE(pair.board.part(&NodeBoard::View::pending)->size(), std::size_t{1});
        QVERIFY(pair.board.part(&NodeBoard::View::pending)->at(0) == rate);
        pair.run(200ms);
        QVERIFY(pair.board.part(&NodeBoard::View::pending)->empty());
        QCOMPARE(pair.board.part(&NodeBoard::View::refusal), (Error{Errc::NotPermitted, {}}));
        pair.client.propose(StationId{}, rate, pair.now);
        static_cast<void>(pair.client.advance(pair.now));
        QVERIFY(!pair.board.part(&NodeBoard::View::refusal));
    }

    void asksForATokenUntilItHasOne()
    {
        Pair pair{logOf({fact::SessionCreated{"Course", "00ff"}})};
        pair.run(500ms);
        std::vector<LocalTime> requests;
        // Only when it asks for a turn: its host is silent.
        for (const LocalTime end = pair.now + 2s; pair.now < end; pair.now += 1ms)
            if (pair.client.nextWake() <= pair.now)
                for (const auto& [to, bytes] : pair.client.advance(pair.now))
                    if (isTokenRequest(bytes))
                        requests.push_back(pair.now);
        QCOMPARE(requests.size(), std::size_t{8});
        for (std::size_t i = 1; i < requests.size(); ++i)
            QVERIFY(requests[i] - requests[i - 1] == 250ms);
    }

    void sharesNothingBeforeItKnowsItsStation()
    {
        Pair pair{logOf({fact::SessionCreated{"Course", "00ff"}})};
        pair.run(500ms);
        pair.client.publish(ObjectKind::Tube, "Tube", [] { return std::nullopt; });
        static_cast<void>(pair.client.advance(pair.now));
        QVERIFY(pair.board.part(&NodeBoard::View::pending)->empty());
    }

    void wakesForTheNextTickWhenItPublishes()
    {
        Pair pair{logOf({fact::SessionCreated{"Course", "00ff"}, fact::StationAdded{"One"},
                         fact::ParticipantJoined{ParticipantId{5}, Role::Trainee, "Anna"}})};
        pair.run(500ms);
        QVERIFY(pair.client.nextWake() > pair.now);
        pair.client.publish(ObjectKind::Tube, "Tube", [] { return std::nullopt; });
        QVERIFY(pair.client.nextWake() <= pair.now);
        static_cast<void>(pair.client.advance(pair.now));
        // The object is proposed at once; the tick comes 60 times a second.
        QVERIFY(pair.client.nextWake() > pair.now);
        QVERIFY(pair.client.nextWake() <= pair.now + 17ms);
        QCOMPARE(pair.board.part(&NodeBoard::View::pending)->size(), std::size_t{1});
    }
};

CARINA_TEST(TestClientDriver)

} // namespace carina::client_driver_test

#include "tst_client_driver.moc"
