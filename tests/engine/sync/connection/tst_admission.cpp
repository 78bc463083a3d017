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
        const SyncHost::Output output = host.take();
        for (const auto& [to, answer] : output.datagrams)
            std::ranges::move(decodeDatagram(answer)->records,
                              std::back_inserter(to == from ? answers : toOthers));
        for (const auto& [address, participant] : output.displaced)
            displaced.push_back(address);
        return answers;
    }
    /// A datagram of a program that is in.
    void hear(PeerAddress from, std::uint32_t connection, LocalTime now)
    {
        const WireRecord ack = FactAck{FactNumber{}};
        const auto bytes = packDatagrams(std::span{&ack, 1}, [&] {
            BundleHeader header;
            header.connection = connection;
            header.sequence = ++sequence;
            return header;
        });
        host.receive(from, bytes.front(), now);
    }
    [[nodiscard]] bool othersWereTold(Errc why) const
    {
        return std::ranges::any_of(toOthers, [why](const WireRecord& record) {
            const auto* refused = std::get_if<HelloRefused>(&record);
            return refused && refused->reason == why;
        });
    }

    std::vector<PeerAddress> displaced;
    std::vector<WireRecord> toOthers;

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
        QVERIFY(alone.session.reasons == std::vector{Leave::Meant});
        QVERIFY(!alone.host.isHere(ParticipantId{1}));
    }

    /// The path of a program that was in, and did not say goodbye.
    void participantWhosePathEndsFallsSilent()
    {
        HostAlone alone;
        QVERIFY(isWelcomed(alone.greet(1, 10, 77, kNow)));
        alone.host.drop(1, kNow + 1ms);
        QVERIFY(alone.session.reasons == std::vector{Leave::Silence});
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
        QVERIFY(alone.displaced.empty());
    }

    /// Both prove the same participant, and both live: the later one comes in, and both are told.
    void twoProgramsWithOneProofShowThemselves()
    {
        HostAlone alone;
        QVERIFY(isWelcomed(alone.greet(1, 10, 77, kNow)));
        const auto wait = alone.greet(2, 20, 88, kNow + 100ms);
        QCOMPARE(std::get<HelloRefused>(wait.at(0)).reason, Errc::NameTaken);
        alone.hear(1, 10, kNow + 100ms + SyncHost::kAliveBeside - 1ns);
        QVERIFY(!isWelcomed(alone.greet(2, 20, 88, kNow + 620ms))); // might have been on its way
        alone.hear(1, 10, kNow + 100ms + SyncHost::kAliveBeside);
        QVERIFY(isWelcomed(alone.greet(2, 20, 88, kNow + 650ms)));
        QCOMPARE(alone.displaced, std::vector<PeerAddress>{1});
        QVERIFY(alone.othersWereTold(Errc::UsedElsewhere));
        QCOMPARE(alone.host.peers().size(), std::size_t{1});
        QVERIFY(alone.host.peers().contains(2));
    }

    /// What was on its way when the first run ended does not count as alive.
    void restartedProgramDisplacesNobody()
    {
        HostAlone alone;
        QVERIFY(isWelcomed(alone.greet(1, 10, 77, kNow)));
        QVERIFY(!isWelcomed(alone.greet(2, 20, 88, kNow + 20ms)));
        alone.hear(1, 10, kNow + 200ms);
        QVERIFY(!isWelcomed(alone.greet(2, 20, 88, kNow + 790ms)));
        QVERIFY(isWelcomed(alone.greet(2, 20, 88, kNow + 800ms)));
        QVERIFY(alone.displaced.empty());
        QVERIFY(!alone.othersWereTold(Errc::UsedElsewhere));
    }

    void nameAloneDisplacesNobody()
    {
        HostAlone alone;
        alone.session.areProven = false;
        QVERIFY(isWelcomed(alone.greet(1, 10, 77, kNow)));
        for (auto later = 100ms; later < 5s; later += 100ms) {
            alone.hear(1, 10, kNow + later);
            QVERIFY(!isWelcomed(alone.greet(2, 20, 88, kNow + later)));
        }
        QVERIFY(alone.displaced.empty());
    }

    void dismissedProgramIsToldWhyAndStaysAway()
    {
        SessionWorld world{33};
        world.addSite({5ms, 0ms, 0.0, 0.0});
        world.startClient(0, "anna");
        world.run(1s);
        world.host().dismiss(ParticipantId{1}, Error{Errc::Removed, "Ina: too loud"},
                             world.hostTime());
        world.run(5s);
        const SyncClient& anna = *world.site(0).client;
        QCOMPARE(anna.state(), SyncClient::State::Closed);
        QCOMPARE(*anna.helloRefused(), (Error{Errc::Removed, "Ina: too loud"}));
        QVERIFY(world.host().peers().empty());
        QVERIFY(world.session.departures.empty());
    }

    void mutedParticipantsSamplesAreNotForwarded()
    {
        SessionWorld world{34};
        for (const char* name : {"anna", "ben"}) {
            const std::size_t site = world.addSite({5ms, 0ms, 0.0, 0.0});
            world.startClient(site, name);
            world.run(500ms);
        }
        const ParticipantId anna = world.site(0).client->self();
        constexpr ObjectId kTube{1};
        world.host().share(kTube, {anna, 1});
        world.site(1).client->share(kTube, {anna, 1});
        std::uint16_t sequence = 0;
        const auto move = [&] {
            StreamCpo cpo;
            cpo.object = kTube;
            cpo.sequence = ++sequence;
            cpo.time = world.trueSessionTime() - 1ms;
            world.site(0).client->publish(StationId{}, cpo);
        };
        world.run(500ms, 20ms, move);
        const std::size_t before = world.site(1).streams.size();
        QVERIFY(before > 10);
        const PeerTraffic& traffic = world.host().peers().begin()->second.traffic;
        QCOMPARE(traffic.refused, std::uint64_t{0});
        QVERIFY(traffic.samples.perSecond(world.hostTime()) > 10.0);
        world.run(100ms);
        world.session.observers.insert(anna);
        const std::size_t atMute = world.site(1).streams.size();
        world.run(500ms, 20ms, move);
        QCOMPARE(world.site(1).streams.size(), atMute);
        QVERIFY(traffic.refused >= 20);
        world.session.observers.clear();
        world.run(500ms, 20ms, move);
        QVERIFY(world.site(1).streams.size() > atMute + 10);
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
        rules.identify = [](const Hello&, LocalTime) { return Identity{ParticipantId{0}}; };
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
