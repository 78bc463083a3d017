#include "engine/sync/wire/datagram_codec.h"
#include "tests/engine/sync/connection/session_world.h"
#include "tests/support/test_class.h"

namespace carina::admission_test
{
namespace
{

using namespace std::chrono_literals;

/// A host whose datagrams are looked at one by one.
struct HostAlone {
    HostAlone() { session.host = &host; }
    HostAlone(const HostAlone&) = delete;
    HostAlone& operator=(const HostAlone&) = delete;

    /// What it answers to a Hello.
    std::vector<WireRecord> greet(PeerAddress from, std::uint32_t connection, std::uint64_t joinId,
                                  LocalTime now, const std::string& name = "anna")
    {
        const ProposalRecord join{ProposalId{joinId}, kNobody, StationId{},
                                  TestSession::body(std::string{"J"}.append(name))};
        const WireRecord hello = Hello{SessionKey{}, FactNumber{}, join};
        const auto bytes = packDatagrams(std::span{&hello, 1}, [&] {
            BundleHeader header;
            header.connection = connection;
            header.sequence = ++sequence;
            return header;
        });
        host.receive(from, bytes.front(), now);
        host.advance(now);
        std::vector<WireRecord> answers;
        for (const auto& [to, answer] : host.take().datagrams)
            if (to == from)
                std::ranges::move(decodeDatagram(answer)->records, std::back_inserter(answers));
        return answers;
    }

    std::uint32_t sequence = 0;
    TestSession session;
    SyncHost host{SessionKey{}, {}, 1000h, session.rules()};
};

bool isWelcomed(const std::vector<WireRecord>& answers)
{
    return !answers.empty() && std::holds_alternative<Welcome>(answers.front());
}

constexpr LocalTime kNow{100s};

} // namespace

class TestAdmission : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void welcomeTellsEverything()
    {
        HostAlone alone;
        const auto answers = alone.greet(1, 10, 77, kNow);
        QCOMPARE(answers.size(), std::size_t{2}); // and the log, which is the join
        const auto& welcome = std::get<Welcome>(answers[0]);
        QCOMPARE(welcome.participant, ParticipantId{1});
        QCOMPARE(welcome.epoch, std::uint16_t{1});
        QCOMPARE(welcome.lastFact, FactNumber{1});
        QCOMPARE(std::get<FactRecord>(answers[1]).proposal, ProposalId{77});
    }

    void nobodyIsWelcomeBeforeTheFactIsOnDisk()
    {
        HostAlone alone;
        alone.session.isFast = false;
        QVERIFY(alone.greet(1, 10, 77, kNow).empty());
        QVERIFY(alone.greet(1, 10, 77, kNow + 25ms).empty());
        QCOMPARE(alone.session.disk.size(), std::size_t{1});
        QVERIFY(alone.host.peers().empty());
        QVERIFY(alone.host.isHere(ParticipantId{1}));
        alone.host.append(alone.session.disk[0]);
        QCOMPARE(alone.host.nextWake(), LocalTime::min());
        alone.host.advance(kNow + 30ms);
        const auto datagrams = alone.host.take().datagrams;
        QCOMPARE(datagrams.size(), std::size_t{1});
        QVERIFY(isWelcomed(decodeDatagram(datagrams[0].bytes)->records));
        QCOMPARE(alone.host.peers().at(1).epoch, std::uint16_t{1});
    }

    void joinThatCannotBeStoredIsRefused()
    {
        HostAlone alone;
        alone.session.isFast = false;
        QVERIFY(alone.greet(1, 10, 77, kNow).empty());
        alone.host.giveUp(alone.session.disk[0], Errc::StoreFailed, kNow);
        const auto datagrams = alone.host.take().datagrams;
        QCOMPARE(datagrams.size(), std::size_t{1});
        const auto records = decodeDatagram(datagrams[0].bytes)->records;
        QCOMPARE(std::get<HelloRefused>(records.at(0)).reason, Errc::StoreFailed);
        QVERIFY(!alone.host.isHere(ParticipantId{1}));
    }

    void nameOfAnArrivalIsHeld()
    {
        HostAlone alone;
        alone.session.isFast = false;
        QVERIFY(alone.greet(1, 10, 77, kNow).empty());
        const auto refused = alone.greet(2, 20, 88, kNow + 1ms);
        QCOMPARE(std::get<HelloRefused>(refused.at(0)).reason, Errc::NameTaken);
    }

    void programThatMovesBeforeItIsOnDiskIsOne()
    {
        HostAlone alone;
        alone.session.isFast = false;
        QVERIFY(alone.greet(1, 10, 77, kNow).empty());
        QVERIFY(alone.greet(2, 11, 77, kNow + 1ms).empty());
        alone.host.append(alone.session.disk[0]);
        alone.host.advance(kNow + 2ms);
        QCOMPARE(alone.host.peers().size(), std::size_t{1});
        QVERIFY(alone.host.peers().contains(2));
        QVERIFY(alone.session.departures.empty());
    }

    void arrivalWhosePathEndsHasLeft()
    {
        HostAlone alone;
        alone.session.isFast = false;
        QVERIFY(alone.greet(1, 10, 77, kNow).empty());
        alone.host.drop(1, kNow + 1ms);
        QCOMPARE(alone.session.departures.size(), std::size_t{1});
        QVERIFY(!alone.host.isHere(ParticipantId{1}));
    }

    void repeatedHelloIsWelcomedAgainWithoutComingInTwice()
    {
        HostAlone alone;
        QVERIFY(isWelcomed(alone.greet(1, 10, 77, kNow)));
        const auto again = alone.greet(1, 10, 77, kNow + 30ms);
        QVERIFY(isWelcomed(again));
        QCOMPARE(again.size(), std::size_t{1}); // the log is under way
        QCOMPARE(alone.session.disk.size(), std::size_t{1});
        QVERIFY(alone.session.departures.empty());
    }

    void helloOfAnEarlierConnectionIsDropped()
    {
        HostAlone alone;
        QVERIFY(isWelcomed(alone.greet(1, 10, 77, kNow)));
        QVERIFY(alone.greet(1, 9, 77, kNow + 30ms).empty());
        QCOMPARE(alone.host.peers().at(1).link.connection(), 10U);
        QVERIFY(isWelcomed(alone.greet(1, 11, 77, kNow + 30ms)));
        QCOMPARE(alone.host.peers().at(1).link.connection(), 11U);
        QCOMPARE(alone.session.disk.size(), std::size_t{1});
    }

    void programThatMovesTakesItsConnectionAlong()
    {
        HostAlone alone;
        QVERIFY(isWelcomed(alone.greet(1, 10, 77, kNow)));
        QVERIFY(isWelcomed(alone.greet(2, 11, 77, kNow + 1ms)));
        QCOMPARE(alone.host.peers().size(), std::size_t{1});
        QVERIFY(alone.host.peers().contains(2));
        QCOMPARE(alone.session.disk.size(), std::size_t{1});
        QVERIFY(alone.session.departures.empty());
    }

    /// The id of a join is in its fact, which everybody has: who only knows that is not let in.
    void idOfAJoinIsNoProof()
    {
        HostAlone alone;
        alone.session.areProven = false;
        QVERIFY(isWelcomed(alone.greet(1, 10, 77, kNow)));
        const auto refused = alone.greet(2, 11, 77, kNow + 1ms);
        QCOMPARE(std::get<HelloRefused>(refused.at(0)).reason, Errc::NameTaken);
        QVERIFY(alone.host.peers().contains(1));
    }

    void nameIsHeldFor600Milliseconds()
    {
        HostAlone alone;
        QVERIFY(isWelcomed(alone.greet(1, 10, 77, kNow)));
        const auto refused = alone.greet(2, 20, 88, kNow + 600ms - 1ns);
        QCOMPARE(refused.size(), std::size_t{1});
        QCOMPARE(std::get<HelloRefused>(refused[0]).reason, Errc::NameTaken);
        QVERIFY(isWelcomed(alone.greet(2, 20, 88, kNow + 600ms)));
        QCOMPARE(alone.host.peers().size(), std::size_t{1});
        QCOMPARE(alone.host.peers().at(2).participant, ParticipantId{1});
    }

    void otherNamesAreWelcomeAtAnyTime()
    {
        HostAlone alone;
        QVERIFY(isWelcomed(alone.greet(1, 10, 77, kNow)));
        QVERIFY(isWelcomed(alone.greet(2, 20, 88, kNow, "ben")));
        QCOMPARE(alone.host.peers().size(), std::size_t{2});
    }

    void hostsOwnNameIsAlwaysTaken()
    {
        HostAlone alone;
        HostRules rules = alone.session.rules();
        rules.identify = [](const ProposalRecord&, LocalTime) {
            return Identity{ParticipantId{0}};
        };
        alone.host = SyncHost{SessionKey{}, {}, 1000h, rules};
        const auto refused = alone.greet(1, 10, 77, kNow);
        QCOMPARE(std::get<HelloRefused>(refused.at(0)).reason, Errc::NameTaken);
        QVERIFY(alone.session.disk.empty());
    }

    void clockIsSetInAQuarterOfASecond()
    {
        SessionWorld world{31};
        world.addSite({5ms, 0ms, 0.0, 0.0});
        world.startClient(0, "anna");
        world.run(225ms);
        QVERIFY(world.site(0).client->clock().mapping());
    }
};

CARINA_TEST(TestAdmission)

} // namespace carina::admission_test

#include "tst_admission.moc"
