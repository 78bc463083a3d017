#include "tests/engine/net/node/nodes.h"
#include "tests/support/test_class.h"

#include <QUdpSocket>

#include <array>
#include <atomic>
#include <ctime>

namespace carina::session_node_test
{

class TestSessionNode : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void opensASession()
    {
        MemoryDisk disk;
        const auto instructor = host(disk);
        QVERIFY(instructor);
        QVERIFY(instructor->port() != 0);
        QCOMPARE(instructor->self(), ParticipantId{0});
        const auto state = instructor->state();
        QCOMPARE(state->name(), std::string{"Course"});
        QCOMPARE(state->sessionId().size(), std::size_t{32});
        QCOMPARE(state->phaseAt(*instructor->now()), SessionPhase::Prepared);
        QCOMPARE(state->stations().at(kStation).name, std::string{"Station 1"});
        const Participant& self = state->participants().at(ParticipantId{0});
        QCOMPARE(self.role, Role::Instructor);
        QVERIFY(self.present);
        // Everything that shows is on disk.
        QCOMPARE(disk.facts.size(), std::size_t{state->lastApplied().value});
        QVERIFY(disk.anchor.has_value());
    }

    /// In the language of who hosts it; a session that is resumed keeps its own.
    void namesTheFirstStationAsItWasTold()
    {
        MemoryDisk disk;
        for (const char* name : {"Poste 1", "Platz 1"}) {
            HostSettings settings = hostSettings(disk);
            settings.firstStation = name;
            const auto node = SessionNode::host(settings, std::make_unique<MemoryStore>(disk));
            QVERIFY(node);
            const auto state = (*node)->state();
            QCOMPARE(state->stations().size(), std::size_t{1});
            QCOMPARE(state->stations().at(kStation).name, std::string{"Poste 1"});
        }
    }

    void sessionsDifferInTimeAndName()
    {
        MemoryDisk disks[2];
        const auto a = host(disks[0]);
        const auto b = host(disks[1]);
        QVERIFY(a->state()->sessionId() != b->state()->sessionId());
        QVERIFY(apart(*a, *b) > 1s); // random epochs over 13 days
    }

    void threeNodesSeeTheSame()
    {
        MemoryDisk disk;
        const auto instructor = host(disk);
        const auto anna = join(*instructor, "Anna");
        const auto ben = join(*instructor, "Ben", Role::Observer);
        QTRY_VERIFY_WITH_TIMEOUT(isIn(*anna) && isIn(*ben), kPatience_ms);
        QVERIFY(anna->self() != ben->self());
        instructor->propose(kStation, fact::BreathingRateSet{perMinute(25.0)});
        QTRY_COMPARE_WITH_TIMEOUT(ratePerMinute(*anna), 25.0, kPatience_ms);
        QTRY_COMPARE_WITH_TIMEOUT(ratePerMinute(*ben), 25.0, kPatience_ms);
        QCOMPARE(ratePerMinute(*instructor), 25.0);
        QCOMPARE(anna->state()->lastApplied(), instructor->state()->lastApplied());
        QVERIFY(apart(*anna, *instructor) < kClockTolerance);
        QVERIFY(apart(*ben, *instructor) < kClockTolerance);
        QCOMPARE(instructor->links().size(), std::size_t{2});
        const LinkReport link = anna->links().at(0);
        QVERIFY(link.roundTrip > 0ms && link.roundTrip < 100ms);
        QVERIFY(link.clockUncertainty > 0ms && link.clockUncertainty < 50ms);
        QVERIFY(link.sinceLastDatagram < 1s);
    }

    // A console that looks at once does not take it for refused.
    void proposalIsPendingUntilItIsDecided()
    {
        MemoryDisk disk;
        const auto instructor = host(disk);
        for (const double rate : {21.0, 22.0, 23.0, 24.0, 25.0}) {
            instructor->propose(kStation, fact::BreathingRateSet{perMinute(rate)});
            QTRY_VERIFY_WITH_TIMEOUT(instructor->pending().empty(), kPatience_ms);
            QCOMPARE(ratePerMinute(*instructor), rate);
        }
    }

    void instructorsElsewhereDecideToo()
    {
        MemoryDisk disk;
        const auto instructor = host(disk);
        const auto second = join(*instructor, "Dr Rolland", Role::Instructor);
        second->propose(kStation, fact::BreathingRateSet{perMinute(12.0)}); // before it is in
        QTRY_COMPARE_WITH_TIMEOUT(ratePerMinute(*instructor), 12.0, kPatience_ms);
        QTRY_VERIFY_WITH_TIMEOUT(second->pending().empty(), kPatience_ms);
        QVERIFY(!second->refusal());
    }

    void traineesAreRefusedWhatTheyMayNot()
    {
        MemoryDisk disk;
        const auto instructor = host(disk);
        const auto anna = join(*instructor, "Anna");
        QTRY_VERIFY_WITH_TIMEOUT(isIn(*anna), kPatience_ms);
        anna->propose(kStation, fact::BreathingRateSet{perMinute(12.0)});
        QTRY_VERIFY_WITH_TIMEOUT(anna->refusal().has_value(), kPatience_ms);
        QCOMPARE(anna->refusal()->code, Errc::NotPermitted);
        QVERIFY(anna->pending().empty());
        instructor->propose(kStation, fact::BreathingRateSet{perMinute(1000.0)});
        QTRY_VERIFY_WITH_TIMEOUT(instructor->refusal().has_value(), kPatience_ms);
        QCOMPARE(instructor->refusal()->code, Errc::OutOfRange);
        QCOMPARE(ratePerMinute(*instructor), 19.0);
    }

    void changesAreAnnounced()
    {
        MemoryDisk disk;
        const auto instructor = host(disk);
        std::atomic<int> changes = 0;
        instructor->onChange([&] { ++changes; });
        instructor->propose(kStation, fact::BreathingRateSet{perMinute(25.0)});
        QTRY_VERIFY_WITH_TIMEOUT(changes > 0, kPatience_ms);
        const auto anna = join(*instructor, "Anna");
        QTRY_VERIFY_WITH_TIMEOUT(isIn(*anna) && changes > 1, kPatience_ms);
        instructor->onChange({});
    }

    void takenPortIsNamed()
    {
        MemoryDisk disks[2];
        const auto first = host(disks[0]);
        const auto second = SessionNode::host({"Other", "Dr Hughes", first->port()},
                                              std::make_unique<MemoryStore>(disks[1]));
        QVERIFY(!second);
        QCOMPARE(second.error(), (Error{Errc::AddressInUse, std::to_string(first->port())}));
        QVERIFY(disks[1].facts.empty());
    }

    void impossibleNamesAreRefusedAtOnce()
    {
        MemoryDisk disk;
        const std::string tooLong(300, 'x');
        using Names = std::array<std::string, 3>;
        for (const auto& [session, person, station] :
             {Names{tooLong, "Dr Hall", "Hall"}, Names{"Course", tooLong, "Hall"},
              Names{"Course", "Dr Hall", tooLong}}) {
            HostSettings settings = hostSettings(disk);
            settings.sessionName = session;
            settings.participantName = person;
            settings.firstStation = station;
            const auto hosted = SessionNode::host(settings, std::make_unique<MemoryStore>(disk));
            QVERIFY(!hosted);
            QCOMPARE(hosted.error().code, Errc::OutOfRange);
        }
        QVERIFY(disk.facts.empty());
        const auto joined = SessionNode::join({1, tooLong, Role::Trainee});
        QVERIFY(!joined);
        QCOMPARE(joined.error().code, Errc::OutOfRange);
    }

    void corruptLogIsNotOpened()
    {
        MemoryDisk disk;
        host(disk).reset();
        disk.facts[1].body = {std::byte{0xFF}};
        const auto node =
            SessionNode::host(hostSettings(disk), std::make_unique<MemoryStore>(disk));
        QVERIFY(!node);
        QCOMPARE(node.error().code, Errc::StoreCorrupt);
        QVERIFY(node.error().detail.starts_with("fact 2"));
    }

    void nothingIsShownThatIsNotOnDisk()
    {
        MemoryDisk disk;
        const auto instructor = host(disk);
        disk.full = true;
        instructor->propose(kStation, fact::BreathingRateSet{perMinute(25.0)});
        QTRY_VERIFY_WITH_TIMEOUT(instructor->refusal().has_value(), kPatience_ms);
        QCOMPARE(instructor->refusal()->code, Errc::StoreFailed);
        QCOMPARE(ratePerMinute(*instructor), 19.0);
    }

    void nonsenseDoesNotDisturb()
    {
        MemoryDisk disk;
        const auto instructor = host(disk);
        QUdpSocket stranger;
        QVERIFY(stranger.bind(QHostAddress::LocalHost, 0));
        for (const qsizetype size : {0, 1, 34, 1200, 1201, 9000})
            stranger.writeDatagram(QByteArray{size, 'C'}, QHostAddress::LocalHost,
                                   instructor->port());
        const auto anna = join(*instructor, "Anna");
        QTRY_VERIFY_WITH_TIMEOUT(isIn(*anna), kPatience_ms);
        QVERIFY(!stranger.hasPendingDatagrams());
    }

    void idleNodesHardlyUseTheProcessor()
    {
        MemoryDisk disk;
        const auto instructor = host(disk);
        const auto anna = join(*instructor, "Anna");
        QTRY_VERIFY_WITH_TIMEOUT(isIn(*anna), kPatience_ms);
        std::clock_t used = std::clock();
        QTest::qWait(500);
        used = std::clock() - used;
        QVERIFY(static_cast<double>(used) / CLOCKS_PER_SEC < 0.05);
    }

    void tellsNobodyOfWhatAProgramAsksByItself()
    {
        MemoryDisk disk;
        const auto instructor = host(disk);
        const auto anna = join(*instructor, "Anna");
        QTRY_VERIFY_WITH_TIMEOUT(isIn(*anna), kPatience_ms);
        instructor->propose(kStation, fact::PhaseChanged{SessionPhase::Running});
        instructor->propose(kStation, fact::PhaseChanged{SessionPhase::Ended});
        const auto hasEnded = [&] {
            return anna->state()->phaseAt(SessionTime::max()) == SessionPhase::Ended;
        };
        QTRY_VERIFY_WITH_TIMEOUT(hasEnded(), kPatience_ms);
        anna->propose(kStation, fact::ManikinBreathed{}); // refused: it has ended
        anna->propose(kStation, fact::ObjectShared{{}, anna->self(), ObjectKind::Jaw, "jaw"});
        QTRY_VERIFY_WITH_TIMEOUT(!anna->state()->objects().empty(), kPatience_ms);
        QVERIFY(!anna->refusal());
        anna->propose(kStation, fact::BreathingRateSet{perMinute(20.0)}); // a person's
        QTRY_VERIFY_WITH_TIMEOUT(anna->refusal(), kPatience_ms);
    }
};

CARINA_TEST(TestSessionNode)

} // namespace carina::session_node_test

#include "tst_session_node.moc"
