#include "tests/engine/net/node/driver_world.h"
#include "tests/support/test_class.h"

#include <algorithm>

namespace carina::slow_disk_test
{
namespace
{

const FactBody kRate = fact::BreathingRateSet{perMinute(25.0)};
const FactBody kVolume = fact::TidalVolumeSet{millilitres(300.0)};

double rateOf(const NodeBoard& board)
{
    const auto state = board.state();
    const auto& patient = state->stations().at(kStation).respiration;
    return inPerMinute(patient.settingsAt(SessionTime::max()).pattern.rate);
}

std::ptrdiff_t guestsOf(const NodeBoard& board)
{
    return std::ranges::count_if(board.state()->participants(), [](const auto& entry) {
        return entry.second.present && entry.first != ParticipantId{0};
    });
}

bool hasKeyOfTrainees(const HostDriver& host)
{
    const PskIdentity trainee{{Role::Trainee, std::nullopt}, host.access().sessionId()};
    return host.access().keyOf(trainee).state == HostTransport::KeyAnswer::State::Known;
}

constexpr PeerAddress kNowhere = 99; ///< a path that the host does not know

/// Lets a guest in and ask for a token, which the host has issued and the held disk not stored.
void issueLostToken(DriverWorld& world, DriverWorld::Guest& guest)
{
    while (guest.board.part(&NodeBoard::View::self) == kNobody)
        world.run(1ms);
    world.disk().hold();
    world.host->propose(kStation, kVolume, world.now);
    world.run(1ms);
}

/// A tube that is seen anew at each turn.
PoseSource tubeOf(const DriverWorld& world, const NodeBoard& board)
{
    return [&]() -> std::optional<PoseSample> {
        const auto clock = board.clock();
        if (!clock)
            return std::nullopt;
        PoseSample sample;
        sample.time = clock->at(world.now);
        return sample;
    };
}

} // namespace

/// A host whose disk is at work for long, or takes nothing.
class TestSlowDisk : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void factsOfATurnAreOneTransaction()
    {
        HeldStore::Disk disk;
        DriverWorld world{disk};
        QVERIFY(world.host);
        QCOMPARE(disk.transactions, (std::vector<std::size_t>{3})); // session, station, host
        for (const double rate : {20.0, 21.0, 22.0, 23.0})
            world.host->propose(kStation, fact::BreathingRateSet{perMinute(rate)}, world.now);
        world.run(1ms);
        QCOMPARE(disk.transactions, (std::vector<std::size_t>{3, 4}));
        QCOMPARE(rateOf(world.board), 23.0);
    }

    void whatIsDecidedWhileTheDiskWorksIsTheNextTransaction()
    {
        HeldStore::Disk disk;
        DriverWorld world{disk};
        disk.hold();
        for (int turn = 0; turn < 5; ++turn) {
            world.host->propose(kStation, kRate, world.now);
            world.run(1ms);
        }
        QCOMPARE(disk.facts.size(), std::size_t{3});
        disk.letGo();
        world.run(2ms);
        QCOMPARE(disk.transactions, (std::vector<std::size_t>{3, 1, 4}));
        QCOMPARE(world.board.state()->lastApplied(), FactNumber{8});
    }

    void whatTheHostProposedIsPendingUntilItIsStored()
    {
        HeldStore::Disk disk;
        DriverWorld world{disk};
        const auto pending = [&world] { return *world.board.part(&NodeBoard::View::pending); };
        QVERIFY(pending().empty());
        disk.hold();
        world.host->propose(kStation, kRate, world.now);
        world.run(1ms);
        QVERIFY(pending() == std::vector{kRate});
        disk.letGo();
        world.run(2ms);
        QVERIFY(pending().empty());
        QCOMPARE(rateOf(world.board), 25.0);
    }

    /// For two seconds nothing is stored: poses and clock replies come as before, the fact reaches
    /// nobody, and everybody once it is stored.
    void slowDiskDelaysNeitherPosesNorClockReplies()
    {
        HeldStore::Disk disk;
        DriverWorld world{disk};
        auto& anna = world.add("Anna");
        auto& ben = world.add("Ben");
        anna.driver->publish(ObjectKind::Tube, "Tube", tubeOf(world, anna.board));
        world.run(500ms);
        QCOMPARE(world.board.state()->objects().size(), std::size_t{1});
        const ObjectId tube = world.board.state()->objects().begin()->first;
        const FactNumber before = world.board.state()->lastApplied();

        disk.hold();
        world.host->propose(kStation, kRate, world.now);
        Duration oldest{};
        world.run(2s, [&] {
            const auto newest = ben.board.objects.find(tube)->newest();
            oldest = std::max(oldest, ben.board.clock()->at(world.now) - newest->time);
        });
        QVERIFY2(oldest < 2 * StreamTick::kPeriod + 2ms,
                 qPrintable(QString::number(toSeconds(oldest))));
        for (const auto* guest : {&anna, &ben}) {
            const NodeBoard::Link link = guest->board.part(&NodeBoard::View::links)->at(0);
            QCOMPARE(link.report.state, LinkState::Connected);
            QVERIFY(world.now - link.lastHeard <= kKeepAlive);
            QVERIFY(guest->board.part(&NodeBoard::View::paths)->at(0).roundTrip <= 2ms);
            QCOMPARE(guest->board.state()->lastApplied(), before);
        }
        QCOMPARE(world.board.state()->lastApplied(), before);

        disk.letGo();
        world.run(20ms);
        for (const NodeBoard* board : {&world.board, &anna.board, &ben.board})
            QCOMPARE(rateOf(*board), 25.0);
    }

    /// A change is not to be in the past when it comes out.
    void slowDiskPutsOffTheEffect()
    {
        HeldStore::Disk disk;
        DriverWorld world{disk};
        world.run(1ms); // the beginning of the session is on disk
        disk.hold();
        world.host->propose(kStation, kRate, world.now);
        world.run(700ms);
        disk.letGo();
        world.run(1ms);
        disk.hold();
        world.host->propose(kStation, kVolume, world.now);
        world.run(1ms);
        disk.letGo();
        world.run(1ms);
        const Duration lead = disk.facts.back().effect - disk.facts.back().committed;
        QVERIFY2(lead >= 700ms && lead < 800ms, qPrintable(QString::number(toSeconds(lead))));
    }

    void nobodyIsInBeforeItIsOnDisk()
    {
        HeldStore::Disk disk;
        DriverWorld world{disk};
        disk.hold();
        const auto& anna = world.add("Anna");
        world.run(1s);
        QCOMPARE(anna.board.part(&NodeBoard::View::self), kNobody);
        QVERIFY(!anna.board.part(&NodeBoard::View::refusal));
        QCOMPARE(guestsOf(world.board), std::ptrdiff_t{0});
        disk.letGo();
        world.run(20ms);
        QCOMPARE(anna.board.part(&NodeBoard::View::self), ParticipantId{1});
        QCOMPARE(guestsOf(world.board), std::ptrdiff_t{1});
        const auto joins = std::ranges::count(disk.facts, kNobody, &FactRecord::author);
        QCOMPARE(joins, std::ptrdiff_t{1}); // however often the Hello was repeated
    }

    void whoseCodeIsChangedBeforeItIsOnDiskIsInAllTheSame()
    {
        HeldStore::Disk disk;
        DriverWorld world{disk};
        QTRY_VERIFY_WITH_TIMEOUT(hasKeyOfTrainees(*world.host), kPatience_ms);
        const JoinCode before = world.host->access().codes().at(Role::Trainee);
        disk.hold();
        const auto& anna = world.add("Anna");
        world.run(100ms);
        world.host->propose(kStation, fact::RoleCodeChanged{Role::Trainee}, world.now);
        QVERIFY(world.host->access().codes().at(Role::Trainee) == before); // not on disk
        QVERIFY(world.host->access().isDeriving(Role::Trainee));
        disk.letGo();
        world.run(1s); // she asks for a token, too
        QVERIFY(world.host->access().codes().at(Role::Trainee) != before);
        QCOMPARE(anna.board.part(&NodeBoard::View::self), ParticipantId{1});
        QCOMPARE(guestsOf(world.board), std::ptrdiff_t{1});
    }

    /// A token holds at once and is sent when it is on disk; meanwhile its owner was silent for so
    /// long that her program took another path. She is in again, and not told that her name is
    /// taken.
    void whoNeverReceivedTheTokenComesBackByTheCode()
    {
        HeldStore::Disk disk;
        DriverWorld world{disk};
        auto& anna = world.add("Anna");
        issueLostToken(world, anna);
        world.movePath(anna);
        disk.letGo();
        world.run(3s);
        QVERIFY(!anna.board.part(&NodeBoard::View::refusal));
        QCOMPARE(anna.board.part(&NodeBoard::View::self), ParticipantId{1});
        QCOMPARE(anna.board.part(&NodeBoard::View::links)->at(0).report.state,
                 LinkState::Connected);
        QCOMPARE(guestsOf(world.board), std::ptrdiff_t{1});
        world.host->propose(kStation, kRate, world.now);
        world.run(20ms);
        QCOMPARE(rateOf(anna.board), 25.0);
    }

    /// But nobody else who knows the code and her name.
    void nobodyElseComesInInsteadOfWhoNeverReceivedTheToken()
    {
        HeldStore::Disk disk;
        DriverWorld world{disk};
        auto& anna = world.add("Anna");
        issueLostToken(world, anna);
        anna.address = kNowhere;
        const auto& other = world.add("Anna");
        disk.letGo();
        world.run(3s);
        QCOMPARE(other.board.part(&NodeBoard::View::refusal)->code, Errc::NameTaken);
        QCOMPARE(other.board.part(&NodeBoard::View::self), kNobody);
    }

    /// Each would cost a second of processor time.
    void codeIsNotChangedBeforeItsKeyIsThere()
    {
        HeldStore::Disk disk;
        DriverWorld world{disk};
        QTRY_VERIFY_WITH_TIMEOUT(hasKeyOfTrainees(*world.host), kPatience_ms);
        for (int i = 0; i < 50; ++i)
            world.host->propose(kStation, fact::RoleCodeChanged{Role::Trainee}, world.now);
        world.run(1ms);
        QCOMPARE(world.board.part(&NodeBoard::View::refusal)->code, Errc::TooMuchSent);
        QVERIFY(disk.facts.size() < 10);
    }

    void whoGoesBeforeItIsOnDiskIsGone()
    {
        HeldStore::Disk disk;
        DriverWorld world{disk};
        disk.hold();
        const auto& anna = world.add("Anna");
        world.run(10ms);
        world.host->disconnected(anna.address, world.now);
        disk.letGo();
        world.host->waitForDisk(world.now);
        world.run(1ms);
        QCOMPARE(world.board.state()->participants().size(), std::size_t{2});
        QCOMPARE(guestsOf(world.board), std::ptrdiff_t{0});
    }

    void whatCannotBeStoredIsRefusedAndUndone()
    {
        HeldStore::Disk disk;
        DriverWorld world{disk};
        auto& second = world.add("Dr Rolland", Role::Instructor);
        world.run(200ms);
        const FactNumber before = world.board.state()->lastApplied();
        disk.hold();
        second.driver->propose(kStation, kRate, world.now);
        world.run(5ms);
        // Decided on the ground of the first, which is not stored.
        world.host->propose(kStation, kVolume, world.now);
        auto& late = world.add("Anna");
        world.run(5ms);
        disk.full = true;
        disk.letGo();
        world.host->waitForDisk(world.now);
        world.run(20ms);
        QCOMPARE(second.board.part(&NodeBoard::View::refusal)->code, Errc::StoreFailed);
        QCOMPARE(late.board.part(&NodeBoard::View::refusal)->code, Errc::StoreFailed);
        QCOMPARE(world.board.part(&NodeBoard::View::refusal)->code, Errc::StoreFailed);
        QVERIFY(second.board.part(&NodeBoard::View::pending)->empty());
        QCOMPARE(world.board.state()->lastApplied(), before);

        disk.full = false;
        second.driver->propose(kStation, kRate, world.now);
        world.run(500ms);
        QCOMPARE(rateOf(second.board), 25.0);
        QVERIFY(!second.board.part(&NodeBoard::View::refusal)
                && !late.board.part(&NodeBoard::View::refusal));
        QCOMPARE(guestsOf(world.board), std::ptrdiff_t{2}); // she asked again
        QCOMPARE(disk.facts.size(), std::size_t(before.value + 2));
    }

    void actionThatCouldNotBeStoredIsStoredOnceItCan()
    {
        HeldStore::Disk disk;
        DriverWorld world{disk};
        world.host->propose(
            kStation, fact::ObjectShared{{}, ParticipantId{0}, ObjectKind::Jaw, "jaw"}, world.now);
        world.run(10ms);
        const ObjectId jaw = world.board.state()->objects().begin()->first;
        const auto turnBy = [&](double rate) {
            world.host->act(jaw, {ActionKind::Rotation, Vec3::UnitZ(), rate, {}}, world.now);
        };
        world.host->waitForDisk(world.now);
        disk.full = true;
        turnBy(1.0);
        world.run(200ms);
        QCOMPARE(world.board.part(&NodeBoard::View::refusal)->code, Errc::StoreFailed);
        QVERIFY(disk.actions.empty());
        turnBy(2.0); // of two the newer one
        world.run(200ms);
        world.host->waitForDisk(world.now);
        disk.full = false;
        world.run(1s);
        QCOMPARE(disk.actions.size(), std::size_t{1});
        QCOMPARE(disk.actions.front().object, jaw);
        QCOMPARE(disk.actions.front().rate, 2.0F);
    }

    /// Two come in the same moment, and neither is stored; the first goes, and the second has its
    /// number.
    void whoseNumberWasUndoneComesInUnderAnother()
    {
        HeldStore::Disk disk;
        DriverWorld world{disk};
        world.run(50ms);
        disk.hold();
        const auto& anna = world.add("Anna");
        auto& ben = world.add("Ben");
        world.run(10ms);
        disk.full = true;
        disk.letGo();
        world.host->waitForDisk(world.now);
        world.host->disconnected(anna.address, world.now);
        disk.full = false;
        world.run(500ms);
        QVERIFY(!ben.board.part(&NodeBoard::View::refusal));
        QCOMPARE(guestsOf(world.board), std::ptrdiff_t{1});
    }

    /// A crowd that comes at once is let in one after another, and nobody is told to go away.
    void crowdComesInWithoutARefusal()
    {
        HeldStore::Disk disk;
        DriverWorld world{disk};
        constexpr std::ptrdiff_t kCrowd = 100;
        const std::vector<DriverWorld::Guest*> crowd = world.addCrowd(kCrowd);
        const auto refused = [&] {
            return std::ranges::any_of(crowd, [](const auto* guest) {
                return guest->board.part(&NodeBoard::View::refusal).has_value();
            });
        };
        world.run(100ms);
        QVERIFY(!refused());
        QVERIFY(guestsOf(world.board) < kCrowd);
        for (int i = 0; i < 30 && guestsOf(world.board) < kCrowd; ++i)
            world.run(100ms);
        QVERIFY(!refused());
        QCOMPARE(guestsOf(world.board), kCrowd);
    }
};

CARINA_TEST(TestSlowDisk)

} // namespace carina::slow_disk_test

#include "tst_slow_disk.moc"
