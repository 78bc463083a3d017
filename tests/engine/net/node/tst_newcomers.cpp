#include "engine/net/node/host_entry.h"
#include "engine/session/participant_limits.h"
#include "tests/engine/net/node/driver_world.h"
#include "tests/support/test_class.h"

#include <algorithm>

namespace carina::newcomers_test
{
namespace
{

std::ptrdiff_t present(const NodeBoard& board, Role role)
{
    return std::ranges::count_if(board.state()->participants(), [role](const auto& entry) {
        const Participant& participant = entry.second;
        return participant.present && participant.role == role && participant.id.value != 0;
    });
}

bool isPresent(const NodeBoard& board, std::string_view name)
{
    return std::ranges::any_of(board.state()->participants(), [name](const auto& entry) {
        return entry.second.present && entry.second.name == name;
    });
}

/// Adds one who does not come from the address of all others.
void addFromElsewhere(DriverWorld& world, const std::string& name, Role role)
{
    constexpr SourcePrefix kElsewhere{9};
    world.host->cameFrom(kElsewhere);
    world.add(name, role);
}

} // namespace

/// How many of those who are new a host admits, and how fast.
class TestNewcomers : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// Who had one role's code kept everybody out for as long as it sent new names.
    void aCrowdOfOneRoleKeepsOutNoOther()
    {
        constexpr int kCrowd = 120;
        HeldStore::Disk disk;
        DriverWorld world{disk};
        QVERIFY(world.host);
        world.addCrowd(kCrowd);
        world.run(20ms);
        constexpr std::ptrdiff_t inAtOnce = 2 * HostEntry::kNewcomers;
        QVERIFY(present(world.board, Role::Trainee) >= inAtOnce);
        QVERIFY(present(world.board, Role::Trainee) < kCrowd);
        world.add("Ina", Role::Instructor);
        world.add("Olga", Role::Observer);
        world.run(20ms);
        QCOMPARE(present(world.board, Role::Instructor), std::ptrdiff_t{1});
        QCOMPARE(present(world.board, Role::Observer), std::ptrdiff_t{1});
        QVERIFY(present(world.board, Role::Trainee) < kCrowd);
    }

    void aCrowdOfOneAddressKeepsOutNobodyElsewhere()
    {
        constexpr int kCrowd = 120;
        HeldStore::Disk disk;
        DriverWorld world{disk};
        QVERIFY(world.host);
        world.addCrowd(kCrowd);
        world.run(20ms);
        QVERIFY(present(world.board, Role::Trainee) < kCrowd);
        addFromElsewhere(world, "Anna", Role::Trainee);
        world.run(20ms);
        QVERIFY(isPresent(world.board, "Anna"));
        QVERIFY(present(world.board, Role::Trainee) < kCrowd);
    }

    /// The places that are left are for people elsewhere.
    void oneAddressTakesNotAllPlaces()
    {
        const std::size_t most = mostPresentFrom(Role::Observer);
        HeldStore::Disk disk;
        DriverWorld world{disk};
        QVERIFY(world.host);
        for (std::size_t i = 0; i < most + 4; ++i)
            world.add("Guest " + std::to_string(i), Role::Observer);
        world.run(500ms);
        QCOMPARE(present(world.board, Role::Observer), std::ptrdiff_t(most));
        QVERIFY(most < mostPresentOf(Role::Observer));
        addFromElsewhere(world, "Olga", Role::Observer);
        world.run(100ms);
        QCOMPARE(present(world.board, Role::Observer), std::ptrdiff_t(most) + 1);
    }

    /// Of an address, some leave, as many come in under other names, and the first come back: they
    /// had then all places for good.
    void placesThatAreKeptCountForTheirAddress()
    {
        const auto most = std::ptrdiff_t(mostPresentFrom(Role::Observer));
        constexpr int kLeaving = 3;
        HeldStore::Disk disk;
        DriverWorld world{disk};
        QVERIFY(world.host);
        std::vector<DriverWorld::Guest*> crowd;
        for (int i = 0; i < most; ++i)
            crowd.push_back(&world.add("Guest " + std::to_string(i), Role::Observer));
        world.run(2s);
        QCOMPARE(present(world.board, Role::Observer), most);
        crowd.resize(kLeaving);
        for (const DriverWorld::Guest* guest : crowd) {
            world.host->disconnected(guest->address, world.now);
            world.add("Another " + std::to_string(guest->address), Role::Observer);
        }
        world.run(500ms);
        QCOMPARE(present(world.board, Role::Observer), most - kLeaving);
        for (DriverWorld::Guest* guest : crowd)
            world.movePath(*guest, Role::Observer);
        world.run(1s);
        QCOMPARE(present(world.board, Role::Observer), most);
    }

    /// Each program asks several times for as long as the disk takes nothing.
    void fullDiskUsesUpNoNames()
    {
        constexpr int kCrowd = 40;
        QVERIFY(std::size_t{2 * HostEntry::kNewcomers + kCrowd} > mostNamesFrom(Role::Observer));
        HeldStore::Disk disk;
        DriverWorld world{disk};
        QVERIFY(world.host);
        world.host->waitForDisk(world.now);
        disk.full = true;
        for (int i = 0; i < kCrowd; ++i)
            world.add("Guest " + std::to_string(i), Role::Observer);
        world.run(2s);
        QCOMPARE(present(world.board, Role::Observer), std::ptrdiff_t{0});
        world.host->waitForDisk(world.now);
        disk.full = false;
        world.run(2s);
        QCOMPARE(present(world.board, Role::Observer), std::ptrdiff_t{kCrowd});
    }
};

CARINA_TEST(TestNewcomers)

} // namespace carina::newcomers_test

#include "tst_newcomers.moc"
