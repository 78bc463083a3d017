#include "engine/core/monotonic_clock.h"
#include "engine/net/session_node.h"
#include "tests/engine/net/memory_store.h"

#include <QTest>
#include <QUdpSocket>

#include <algorithm>
#include <atomic>

namespace carina
{
namespace
{

using namespace std::chrono_literals;

constexpr int kSoonMs = 2000;
constexpr StationId kStation{0};
constexpr Duration kClockTolerance = 5ms;

std::unique_ptr<SessionNode> host(MemoryDisk& disk, std::uint16_t port = 0)
{
    auto node = SessionNode::host({"Course", "Dr Hall", port}, std::make_unique<MemoryStore>(disk));
    return node ? *std::move(node) : nullptr;
}

std::unique_ptr<SessionNode> join(std::uint16_t port, const char* name, Role role = Role::Trainee)
{
    auto node = SessionNode::join({port, name, role, kStation});
    return node ? *std::move(node) : nullptr;
}

LinkState linkOf(const SessionNode& client) { return client.links().at(0).state; }

bool isIn(const SessionNode& client)
{
    return linkOf(client) == LinkState::Connected && client.now().has_value();
}

double ratePerMinute(const SessionNode& node)
{
    const auto state = node.state();
    const auto station = state->stations().find(kStation);
    if (station == state->stations().end())
        return 0.0;
    return inPerMinute(station->second.breathing.settingsAt(*node.now() + 10s).rate);
}

Duration apart(const SessionNode& a, const SessionNode& b)
{
    const LocalTime now = monotonicNow();
    return std::chrono::abs(*a.sessionTime(now) - *b.sessionTime(now));
}

/// A tube that stands still, seen anew at each asking.
PoseSource stillTube(const SessionNode& node)
{
    return [&node]() -> std::optional<PoseSample> {
        const auto now = node.now();
        if (!now)
            return std::nullopt;
        PoseSample sample;
        sample.time = *now;
        sample.X_FO = RigidTransform::translation(Vec3{0.1, 0.2, 0.3});
        sample.motion = Motion{};
        return sample;
    };
}

std::shared_ptr<const PoseHistory> onlyObject(const SessionNode& node)
{
    const auto state = node.state();
    return state->objects().empty() ? nullptr : node.object(state->objects().begin()->first);
}

} // namespace

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
        const auto anna = join(instructor->port(), "Anna");
        const auto ben = join(instructor->port(), "Ben", Role::Observer);
        QTRY_VERIFY_WITH_TIMEOUT(isIn(*anna) && isIn(*ben), kSoonMs);
        QVERIFY(anna->self() != ben->self());
        instructor->propose(kStation, fact::BreathingRateSet{perMinute(25.0)});
        QTRY_COMPARE_WITH_TIMEOUT(ratePerMinute(*anna), 25.0, kSoonMs);
        QTRY_COMPARE_WITH_TIMEOUT(ratePerMinute(*ben), 25.0, kSoonMs);
        QCOMPARE(ratePerMinute(*instructor), 25.0);
        QCOMPARE(anna->state()->lastApplied(), instructor->state()->lastApplied());
        QVERIFY(apart(*anna, *instructor) < kClockTolerance);
        QVERIFY(apart(*ben, *instructor) < kClockTolerance);
        QCOMPARE(instructor->links().size(), std::size_t{2});
        const LinkReport link = anna->links().at(0);
        QVERIFY(link.roundTrip > 0ms && link.roundTrip < 100ms);
        QVERIFY(link.clockUncertainty >= link.roundTrip / 2);
        QVERIFY(link.sinceLastDatagram < 1s);
    }

    void instructorsElsewhereDecideToo()
    {
        MemoryDisk disk;
        const auto instructor = host(disk);
        const auto second = join(instructor->port(), "Dr Rolland", Role::Instructor);
        second->propose(kStation, fact::BreathingRateSet{perMinute(12.0)}); // before it is in
        QTRY_COMPARE_WITH_TIMEOUT(ratePerMinute(*instructor), 12.0, kSoonMs);
        QTRY_VERIFY_WITH_TIMEOUT(second->pending().empty(), kSoonMs);
        QVERIFY(!second->refusal());
    }

    void traineesAreRefusedWhatTheyMayNot()
    {
        MemoryDisk disk;
        const auto instructor = host(disk);
        const auto anna = join(instructor->port(), "Anna");
        QTRY_VERIFY_WITH_TIMEOUT(isIn(*anna), kSoonMs);
        anna->propose(kStation, fact::BreathingRateSet{perMinute(12.0)});
        QTRY_VERIFY_WITH_TIMEOUT(anna->refusal().has_value(), kSoonMs);
        QCOMPARE(anna->refusal()->code, Errc::NotPermitted);
        QVERIFY(anna->pending().empty());
        instructor->propose(kStation, fact::BreathingRateSet{perMinute(1000.0)});
        QTRY_VERIFY_WITH_TIMEOUT(instructor->refusal().has_value(), kSoonMs);
        QCOMPARE(instructor->refusal()->code, Errc::OutOfRange);
        QCOMPARE(ratePerMinute(*instructor), 19.0);
    }

    void hostThatComesBackIsFoundWithItsTime()
    {
        MemoryDisk disk;
        auto instructor = host(disk);
        const std::uint16_t port = instructor->port();
        const auto anna = join(port, "Anna");
        QTRY_VERIFY_WITH_TIMEOUT(isIn(*anna), kSoonMs);
        const LocalTime moment = monotonicNow();
        const SessionTime before = *instructor->sessionTime(moment);
        const std::string id = instructor->state()->sessionId();

        instructor.reset();
        QTRY_COMPARE_WITH_TIMEOUT(linkOf(*anna), LinkState::Away, kSoonMs);
        QVERIFY(anna->now().has_value()); // the clock runs on
        instructor = host(disk, port);
        QVERIFY(instructor);
        QTRY_COMPARE_WITH_TIMEOUT(linkOf(*anna), LinkState::Connected, kSoonMs);
        QCOMPARE(instructor->state()->sessionId(), id);
        QCOMPARE(*instructor->sessionTime(moment), before);
        QTRY_COMPARE_WITH_TIMEOUT(anna->state()->lastApplied(), instructor->state()->lastApplied(),
                                  kSoonMs);
        QVERIFY(apart(*anna, *instructor) < kClockTolerance);
    }

    void proposalWhileTheHostIsAwayArrivesOnce()
    {
        MemoryDisk disk;
        auto instructor = host(disk);
        const std::uint16_t port = instructor->port();
        const auto second = join(port, "Dr Rolland", Role::Instructor);
        QTRY_VERIFY_WITH_TIMEOUT(isIn(*second), kSoonMs);
        instructor.reset();
        second->propose(kStation, fact::BreathingRateSet{perMinute(30.0)});
        QTRY_COMPARE_WITH_TIMEOUT(second->pending().size(), std::size_t{1}, kSoonMs);
        QVERIFY(second->pending().front() == FactBody{fact::BreathingRateSet{perMinute(30.0)}});
        const std::size_t facts = disk.facts.size();
        instructor = host(disk, port);
        QTRY_VERIFY_WITH_TIMEOUT(second->pending().empty(), kSoonMs);
        QCOMPARE(ratePerMinute(*instructor), 30.0);
        QTRY_COMPARE_WITH_TIMEOUT(ratePerMinute(*second), 30.0, kSoonMs);
        instructor.reset();
        QCOMPARE(disk.facts.size(), facts + 2); // the host came in again, and the rate
    }

    void restartedTraineeIsTheSameParticipant()
    {
        MemoryDisk disk;
        const auto instructor = host(disk);
        auto anna = join(instructor->port(), "Anna");
        QTRY_VERIFY_WITH_TIMEOUT(isIn(*anna), kSoonMs);
        const ParticipantId id = anna->self();
        const auto present = [&] { return instructor->state()->participants().at(id).present; };
        QVERIFY(present());
        anna.reset();
        QTRY_VERIFY_WITH_TIMEOUT(!present(), kSoonMs);
        anna = join(instructor->port(), "Anna");
        QTRY_VERIFY_WITH_TIMEOUT(isIn(*anna), kSoonMs);
        QCOMPARE(anna->self(), id);
        QTRY_VERIFY_WITH_TIMEOUT(present(), kSoonMs);
        QTRY_COMPARE_WITH_TIMEOUT(anna->state()->lastApplied(), instructor->state()->lastApplied(),
                                  kSoonMs);
    }

    void participantsWhoDoNotReturnToARestartedHostAreGone()
    {
        MemoryDisk disk;
        auto instructor = host(disk);
        const std::uint16_t port = instructor->port();
        auto anna = join(port, "Anna");
        const auto ben = join(port, "Ben");
        QTRY_VERIFY_WITH_TIMEOUT(isIn(*anna) && isIn(*ben), kSoonMs);
        const ParticipantId annaId = anna->self();
        instructor.reset();
        anna.reset();
        instructor = host(disk, port);
        const auto present = [&](ParticipantId id) {
            return instructor->state()->participants().at(id).present;
        };
        QVERIFY(present(annaId));
        QTRY_VERIFY_WITH_TIMEOUT(!present(annaId), 5000); // three seconds of grace
        QVERIFY(present(ben->self()));
    }

    void namesAreTakenWhileTheirOwnersLive()
    {
        MemoryDisk disk;
        const auto instructor = host(disk);
        const auto anna = join(instructor->port(), "Anna");
        QTRY_VERIFY_WITH_TIMEOUT(isIn(*anna), kSoonMs);
        const auto other = join(instructor->port(), "Anna");
        const auto usurper = join(instructor->port(), "Dr Hall", Role::Instructor);
        QTRY_VERIFY_WITH_TIMEOUT(other->refusal() && usurper->refusal(), kSoonMs);
        QCOMPARE(other->refusal()->code, Errc::NameTaken);
        QCOMPARE(usurper->refusal()->code, Errc::NameTaken);
        QCOMPARE(other->self(), kNobody);
        QCOMPARE(linkOf(*other), LinkState::Connecting);
        // Another role is another person.
        const auto watcher = join(instructor->port(), "Anna", Role::Observer);
        QTRY_VERIFY_WITH_TIMEOUT(isIn(*watcher), kSoonMs);
    }

    void posesReachTheOthers()
    {
        MemoryDisk disk;
        const auto instructor = host(disk);
        const auto anna = join(instructor->port(), "Anna");
        const auto ben = join(instructor->port(), "Ben");
        anna->publish(kStation, ObjectKind::Tube, "Tube", stillTube(*anna));
        for (const auto* node : {instructor.get(), ben.get()}) {
            QTRY_VERIFY_WITH_TIMEOUT(onlyObject(*node) && onlyObject(*node)->newest(), kSoonMs);
            const auto pose = onlyObject(*node)->at(*node->now());
            QVERIFY(pose);
            QCOMPARE(pose->validity, Validity::Tracked);
            QVERIFY((pose->X_FO.translation() - Vec3{0.1, 0.2, 0.3}).norm() < 1e-5);
            const auto reports = node->objectReports();
            QCOMPARE(reports.size(), std::size_t{1});
            QVERIFY(reports[0].age < 200ms);
            QTRY_VERIFY_WITH_TIMEOUT(node->objectReports()[0].driftMm < 0.02, kSoonMs);
        }
        QVERIFY(!onlyObject(*anna)); // one's own is not fetched from the session
        QVERIFY(anna->objectReports().empty());
        const SharedObject object = instructor->state()->objects().begin()->second;
        QCOMPARE(object.owner, anna->self());
        QCOMPARE(object.kind, ObjectKind::Tube);
        QCOMPARE(object.name, std::string{"Tube"});
    }

    void hostsPosesReachTheOthers()
    {
        MemoryDisk disk;
        const auto instructor = host(disk);
        instructor->publish(kStation, ObjectKind::Head, "Head", stillTube(*instructor));
        const auto anna = join(instructor->port(), "Anna");
        QTRY_VERIFY_WITH_TIMEOUT(onlyObject(*anna) && onlyObject(*anna)->newest(), kSoonMs);
    }

    void posesGoStaleWhenTheirOwnerFallsSilent()
    {
        MemoryDisk disk;
        const auto instructor = host(disk);
        auto anna = join(instructor->port(), "Anna");
        anna->publish(kStation, ObjectKind::Tube, "Tube", stillTube(*anna));
        QTRY_VERIFY_WITH_TIMEOUT(onlyObject(*instructor) && onlyObject(*instructor)->newest(),
                                 kSoonMs);
        anna.reset();
        const auto tube = onlyObject(*instructor);
        const SessionTime last = tube->newest()->time;
        QCOMPARE(tube->at(last + 300ms)->validity, Validity::Tracked);
        QCOMPARE(tube->at(last + 301ms)->validity, Validity::Lost);
    }

    void posesGoOnAfterTheHostComesBack()
    {
        MemoryDisk disk;
        auto instructor = host(disk);
        const std::uint16_t port = instructor->port();
        const auto anna = join(port, "Anna");
        anna->publish(kStation, ObjectKind::Tube, "Tube", stillTube(*anna));
        QTRY_VERIFY_WITH_TIMEOUT(onlyObject(*instructor) && onlyObject(*instructor)->newest(),
                                 kSoonMs);
        instructor.reset();
        instructor = host(disk, port);
        QTRY_VERIFY_WITH_TIMEOUT(onlyObject(*instructor)->newest().has_value(), kSoonMs);
        QCOMPARE(instructor->state()->objects().size(), std::size_t{1});
    }

    void changesAreAnnounced()
    {
        MemoryDisk disk;
        const auto instructor = host(disk);
        std::atomic<int> changes = 0;
        instructor->onChange([&] { ++changes; });
        instructor->propose(kStation, fact::BreathingRateSet{perMinute(25.0)});
        QTRY_VERIFY_WITH_TIMEOUT(changes > 0, kSoonMs);
        const auto anna = join(instructor->port(), "Anna");
        QTRY_VERIFY_WITH_TIMEOUT(isIn(*anna) && changes > 1, kSoonMs);
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
        for (const auto& [session, person] :
             {std::pair{tooLong, std::string{"Dr Hall"}}, {std::string{"Course"}, tooLong}}) {
            const auto hosted =
                SessionNode::host({session, person, 0}, std::make_unique<MemoryStore>(disk));
            QVERIFY(!hosted);
            QCOMPARE(hosted.error().code, Errc::OutOfRange);
        }
        QVERIFY(disk.facts.empty());
        const auto joined = SessionNode::join({1, tooLong, Role::Trainee, kStation});
        QVERIFY(!joined);
        QCOMPARE(joined.error().code, Errc::OutOfRange);
    }

    void corruptLogIsNotOpened()
    {
        MemoryDisk disk;
        host(disk).reset();
        disk.facts[1].body = {std::byte{0xFF}};
        const auto node =
            SessionNode::host({"Course", "Dr Hall", 0}, std::make_unique<MemoryStore>(disk));
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
        QTRY_VERIFY_WITH_TIMEOUT(instructor->refusal().has_value(), kSoonMs);
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
        const auto anna = join(instructor->port(), "Anna");
        QTRY_VERIFY_WITH_TIMEOUT(isIn(*anna), kSoonMs);
        QVERIFY(!stranger.hasPendingDatagrams());
    }

    void idleNodesHardlyUseTheProcessor()
    {
        MemoryDisk disk;
        const auto instructor = host(disk);
        const auto anna = join(instructor->port(), "Anna");
        QTRY_VERIFY_WITH_TIMEOUT(isIn(*anna), kSoonMs);
        std::clock_t used = std::clock();
        QTest::qWait(500);
        used = std::clock() - used;
        QVERIFY(static_cast<double>(used) / CLOCKS_PER_SEC < 0.05);
    }
};

} // namespace carina

QTEST_GUILESS_MAIN(carina::TestSessionNode)
#include "tst_session_node.moc"
