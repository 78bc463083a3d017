#include "engine/net/entry/token_message.h"
#include "engine/net/node/host_paths.h"
#include "engine/sync/wire/datagram_codec.h"
#include "tests/engine/net/node/driver_world.h"
#include "tests/support/test_class.h"

namespace carina::host_paths_test
{
namespace
{

constexpr LocalTime kStart{1h};
constexpr Credential kTrainees{Role::Trainee, std::nullopt};
constexpr SourcePrefix kHere{1};
constexpr SourcePrefix kElsewhere{2};

} // namespace

class TestHostPaths : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void pathOverWhichNobodyTakesPartIsEndedBeyondItsDatagrams()
    {
        bool isInUse = false;
        HostPaths paths{[&](PeerAddress) { return isInUse; }};
        paths.connected(1, kTrainees, kHere, kStart);
        paths.connected(2, kTrainees, kHere, kStart);
        int heard = 0;
        for (int i = 0; i < 1000; ++i)
            heard += paths.hears(1, kStart) ? 1 : 0;
        QCOMPARE(heard, int(2.0 * HostPaths::kIdleDatagrams));
        QCOMPARE(paths.takeEnded(), std::vector<PeerAddress>{1}); // once
        QVERIFY(!paths.hears(1, kStart + 1h));
        QVERIFY(paths.hears(2, kStart));
        isInUse = true; // then the budget of its participant counts
        for (int i = 0; i < 1000; ++i)
            QVERIFY(paths.hears(2, kStart));
    }

    void idlePathsOfAllCredentialsTogetherAreLimited()
    {
        HostPaths paths{[](PeerAddress) { return false; }};
        for (PeerAddress path = 1; path <= HostPaths::kMostIdle; ++path) {
            const ParticipantId who{static_cast<std::uint16_t>(path / HostPaths::kMostIdleOfToken)};
            paths.connected(path, {Role::Trainee, who}, kHere, kStart + path * 1us);
        }
        QVERIFY(paths.takeEnded().empty());
        paths.connected(5000, kTrainees, kElsewhere, kStart + 1ms);
        QCOMPARE(paths.takeEnded(), std::vector<PeerAddress>{1});
    }

    void idlePathsOfOneAddressEndNoneFromElsewhere()
    {
        HostPaths paths{[](PeerAddress) { return false; }};
        paths.connected(5000, kTrainees, kElsewhere, kStart);
        for (PeerAddress path = 1; path <= HostPaths::kMostIdleOfCode; ++path)
            paths.connected(path, kTrainees, kHere, kStart + path * 1us);
        QVERIFY(paths.takeEnded().empty());
        paths.connected(5001, kTrainees, kHere, kStart + 1ms);
        QCOMPARE(paths.takeEnded(), std::vector<PeerAddress>{1});
    }

    /// However long the disk takes.
    void pathIsNotIdleWhileItsParticipantWaitsForTheDisk()
    {
        bool isArriving = true;
        HostPaths paths{[](PeerAddress) { return false; }, [&](PeerAddress) { return isArriving; }};
        paths.connected(1, kTrainees, kHere, kStart);
        const LocalTime late = kStart + 1min;
        paths.advance(late);
        isArriving = false;
        paths.advance(late + HostPaths::kHelloWithin - 1ns);
        QVERIFY(paths.takeEnded().empty());
        paths.advance(paths.nextWake());
        QCOMPARE(paths.takeEnded(), std::vector<PeerAddress>{1});
    }

    /// Its Hello may arrive before it is closed, and would have come from nowhere.
    void pathThatGaveWayIsNotHeard()
    {
        HostPaths paths{[](PeerAddress) { return false; }};
        const auto open = [&](PeerAddress path) {
            paths.connected(path, kTrainees, kHere, kStart + path * 1us);
        };
        for (PeerAddress path = 1; path <= HostPaths::kMostIdleOfCode; ++path)
            open(path);
        open(5000);
        QVERIFY(!paths.hears(1, kStart + 6ms));
        QCOMPARE(paths.sourceOf(1), kHere);
        open(5001); // another gives way to it
        QCOMPARE(paths.takeEnded(), (std::vector<PeerAddress>{1, 2}));
        paths.disconnected(1);
        paths.advance(kStart + HostPaths::kHelloWithin + 3us);
        QCOMPARE(paths.takeEnded(), std::vector<PeerAddress>{3}); // the others only once
    }

    void budgetIsSharedByThoseOfOneAddressInOneRole()
    {
        HostPaths paths{[](PeerAddress) { return true; }};
        paths.connected(1, kTrainees, kHere, kStart);
        paths.connected(2, {Role::Trainee, ParticipantId{7}}, kHere, kStart);
        paths.connected(3, {Role::Observer, std::nullopt}, kHere, kStart);
        paths.connected(4, kTrainees, kElsewhere, kStart);
        const auto shared = paths.sharedBudget(1);
        QVERIFY(shared);
        QCOMPARE(paths.sharedBudget(2), shared);
        const auto others = paths.sharedBudget(3);
        const auto elsewhere = paths.sharedBudget(4);
        QVERIFY(others != shared && elsewhere != shared);
        QCOMPARE(paths.sharedBudget(1), shared);
        QVERIFY(!paths.sharedBudget(9));
    }

    /// A stranger with a code who says no Hello, and what it is answered.
    void floodOverAPathWithoutAParticipantIsHardlyAnswered()
    {
        HeldStore::Disk disk;
        DriverWorld world{disk};
        QVERIFY(world.host);
        world.host->connected(7, kTrainees, world.now);
        const WireRecord record = FactAck{};
        const auto bytes =
            packDatagrams(std::span{&record, 1}, [] { return BundleHeader{}; }).front();
        for (int i = 0; i < 1000; ++i)
            world.host->receive(7, bytes, world.now);
        QVERIFY(world.host->advance(world.now).size()
                <= std::size_t(2.0 * HostPaths::kIdleDatagrams));
        QCOMPARE(world.host->takeEnded(), std::vector<PeerAddress>{7});
    }

    void requestsForATokenCountAsDatagrams()
    {
        HeldStore::Disk disk;
        DriverWorld world{disk};
        QVERIFY(world.host);
        const auto& guest = world.add("Anna", Role::Observer);
        world.run(200ms);
        QVERIFY(guest.board.part(&NodeBoard::View::self) != kNobody);
        for (int i = 0; i < 40'000; ++i)
            world.host->receive(guest.address, encodeTokenRequest(), world.now);
        static_cast<void>(world.host->advance(world.now));
        QCOMPARE(world.host->takeEnded(), std::vector<PeerAddress>{guest.address});
    }
};

CARINA_TEST(TestHostPaths)

} // namespace carina::host_paths_test

#include "tst_host_paths.moc"
