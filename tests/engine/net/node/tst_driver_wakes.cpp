#include "tests/engine/net/node/driver_world.h"
#include "tests/support/test_class.h"

#include <algorithm>

namespace carina::driver_wakes_test
{
namespace
{

/// Of the turns of a DriverWorld, there and back.
constexpr Duration kTurns = 3ms;
constexpr Duration kTick = 17ms;
const ObjectAction kTurning{.axis_A = Vec3::UnitZ(), .rate = 1.0};

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

std::optional<ObjectId> onlyObject(const NodeBoard& board)
{
    const auto state = board.state();
    return state->objects().size() == 1 ? std::optional{state->objects().begin()->first}
                                        : std::nullopt;
}

/// How old the newest comparison of a view is; nothing where there is none.
std::optional<Duration> ageOfComparison(const NodeBoard& board, LocalTime now)
{
    const auto drifts = board.part(&NodeBoard::View::drifts);
    if (drifts->empty())
        return std::nullopt;
    return board.clock()->at(now) - drifts->begin()->second.at;
}

} // namespace

/// Drivers that have a turn only when nextWake() asks for one, or when they hear of something.
class TestDriverWakes : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void posesGoAtEveryTick_data()
    {
        QTest::addColumn<bool>("isHosts");
        QTest::newRow("of the host") << true;
        QTest::newRow("of a participant") << false;
    }
    void posesGoAtEveryTick()
    {
        QFETCH(bool, isHosts);
        HeldStore::Disk disk;
        DriverWorld world{disk};
        auto& guest = world.add("Anna");
        NodeBoard& viewer = isHosts ? guest.board : world.board;
        NodeBoard& owner = isHosts ? world.board : guest.board;
        NodeDriver& driver = isHosts ? static_cast<NodeDriver&>(*world.host)
                                     : static_cast<NodeDriver&>(*guest.driver);
        world.runByWakes(500ms);
        driver.publish(ObjectKind::Tube, "Tube", tubeOf(world, owner));
        world.runByWakes(500ms);
        Duration oldest{};
        world.runByWakes(1s, [&] {
            for (const ObjectReport& report : viewer.objectReports(viewer.clock()->at(world.now)))
                oldest = std::max(oldest, report.age);
        });
        QVERIFY(oldest > 0ms);
        QVERIFY2(oldest <= kTick + kTurns, qPrintable(QString::number(oldest.count())));
    }

    void viewsAreComparedWhenTheyAreDue_data()
    {
        QTest::addColumn<bool>("isHosts");
        QTest::newRow("the host owns the object") << true;
        QTest::newRow("a participant owns the object") << false;
    }
    void viewsAreComparedWhenTheyAreDue()
    {
        QFETCH(bool, isHosts);
        HeldStore::Disk disk;
        DriverWorld world{disk};
        auto& guest = world.add("Anna");
        NodeBoard& viewer = isHosts ? guest.board : world.board;
        NodeDriver& owner = isHosts ? static_cast<NodeDriver&>(*world.host)
                                    : static_cast<NodeDriver&>(*guest.driver);
        world.runByWakes(500ms);
        const ParticipantId self =
            isHosts ? ParticipantId{0} : guest.board.part(&NodeBoard::View::self);
        owner.propose(kStation, fact::ObjectShared{{}, self, ObjectKind::Tube, "Tube"}, world.now);
        world.runByWakes(500ms);
        const auto object = onlyObject(viewer);
        QVERIFY(object);
        owner.act(*object, kTurning, world.now);
        world.runByWakes(500ms);
        Duration oldest{};
        world.runByWakes(2s, [&] {
            oldest = std::max(oldest, ageOfComparison(viewer, world.now).value_or(1h));
        });
        QVERIFY2(oldest <= ViewComparison::kPeriod + kTurns,
                 qPrintable(QString::number(oldest.count())));
    }

    void whoDoesNotReturnIsDroppedInTime()
    {
        HeldStore::Disk disk;
        {
            DriverWorld before{disk};
            before.add("Anna");
            before.run(500ms);
        }
        DriverWorld world{disk};
        const auto arePresent = [&] {
            return std::ranges::count_if(world.board.state()->participants(),
                                         [](const auto& who) { return who.second.present; });
        };
        world.runByWakes(kPeerTimeout - kTurns);
        QCOMPARE(arePresent(), std::ptrdiff_t{2});
        world.runByWakes(2 * kTurns);
        QCOMPARE(arePresent(), std::ptrdiff_t{1});
        const auto state = world.board.state();
        for (const auto& [id, who] : state->participants())
            QVERIFY(!who.fellSilent); // nobody knows whether they wanted to come back
    }

    /// One whose program is killed, and another one who leaves.
    void whoFallsSilentIsToldFromWhoLeaves()
    {
        HeldStore::Disk disk;
        DriverWorld world{disk};
        auto& anna = world.add("Anna");
        auto& ben = world.add("Ben");
        world.run(500ms);
        const ParticipantId silent = anna.board.part(&NodeBoard::View::self);
        const ParticipantId left = ben.board.part(&NodeBoard::View::self);
        for (const auto& [to, bytes] : ben.driver->close(world.now))
            world.host->receive(ben.address, bytes, world.now);
        for (const LocalTime end = world.now + kPeerTimeout + 500ms; world.now < end;
             world.now += 1ms) {
            static_cast<void>(world.host->advance(world.now));
            world.host->waitForDisk(world.now);
        }
        const auto state = world.board.state();
        QVERIFY(!state->isPresent(silent) && state->participants().at(silent).fellSilent);
        QVERIFY(!state->isPresent(left) && !state->participants().at(left).fellSilent);
    }

    void pathsThatNobodyUsesEnd()
    {
        constexpr PeerAddress kIdle = 77;
        HeldStore::Disk disk;
        DriverWorld world{disk};
        world.runByWakes(100ms);
        world.host->connected(kIdle, {Role::Trainee, std::nullopt}, world.now);
        std::vector<PeerAddress> ended;
        world.runByWakes(HostPaths::kHelloWithin + HostPaths::kLook + kTurns, [&] {
            std::ranges::copy(world.host->takeEnded(), std::back_inserter(ended));
        });
        QCOMPARE(ended, std::vector<PeerAddress>{kIdle});
    }

    void filesOfTheStoreAreWatched()
    {
        HeldStore::Disk disk;
        DriverWorld world{disk};
        world.runByWakes(1s);
        QVERIFY(!world.board.part(&NodeBoard::View::refusal));
        disk.moved = disk.folder.filePath(QStringLiteral("elsewhere")).toStdString();
        world.runByWakes(500ms + kTurns);
        QVERIFY(world.board.part(&NodeBoard::View::refusal));
        QCOMPARE(world.board.part(&NodeBoard::View::refusal)->code, Errc::StoreReplaced);
    }
};

CARINA_TEST(TestDriverWakes)

} // namespace carina::driver_wakes_test

#include "tst_driver_wakes.moc"
