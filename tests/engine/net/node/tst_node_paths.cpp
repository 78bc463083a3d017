#include "tests/engine/net/node/driver_world.h"
#include "tests/support/test_class.h"

namespace carina::node_paths_test
{
namespace
{

constexpr Duration kLongestLoopback = 100ms;

} // namespace

class TestNodePaths : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theHostMeasuresThePathToEverybody()
    {
        MemoryDisk disk;
        const auto instructor = host(disk);
        QVERIFY(instructor->paths()->empty());
        const auto anna = join(*instructor, "Anna");
        const auto ben = join(*instructor, "Ben");
        anna->publish(ObjectKind::Tube, "Tube", stillTube(*anna));
        const auto isMeasured = [&](const SessionNode& node) {
            const auto paths = instructor->paths();
            const auto path = std::ranges::find(*paths, node.self(), &PathReport::peer);
            return path != paths->end() && path->clockOffset;
        };
        QTRY_VERIFY_WITH_TIMEOUT(isMeasured(*anna), kPatience_ms);
        QTRY_VERIFY_WITH_TIMEOUT(isMeasured(*ben), 5 * kPatience_ms);
        const LocalTime now = monotonicNow();
        const Duration offset =
            instructor->sessionTime(now)->time_since_epoch() - now.time_since_epoch();
        for (const PathReport& path : *instructor->paths()) {
            QVERIFY(path.roundTrip.value() > 0ns && path.roundTrip.value() < kLongestLoopback);
            QVERIFY(path.delays.size() >= 10);
            QVERIFY(path.meanDelay.value() < kLongestLoopback);
            QVERIFY(path.sigma.value() < kLongestLoopback);
            QVERIFY(path.probesPerSecond.value() >= 1.0);
            // All of one machine read the same clock.
            QVERIFY(std::chrono::abs(*path.clockOffset - offset) < kClockTolerance);
            QVERIFY(path.clockErrorBound.value() < kLongestLoopback);
            QVERIFY(path.clockError.has_value());
        }
        const auto lossOfAnna = [&] {
            const auto paths = instructor->paths();
            const auto path = std::ranges::find(*paths, anna->self(), &PathReport::peer);
            return path == paths->end() ? std::nullopt : path->loss;
        };
        QTRY_VERIFY_WITH_TIMEOUT(lossOfAnna(), kPatience_ms); // a hundred datagrams
        QVERIFY(*lossOfAnna() < 0.5);
    }

    void everybodyElseMeasuresThePathToTheHost()
    {
        MemoryDisk disk;
        const auto instructor = host(disk);
        const auto anna = join(*instructor, "Anna");
        QCOMPARE(anna->paths()->size(), std::size_t{1});
        QCOMPARE(anna->paths()->front().peer, ParticipantId{0});
        QTRY_VERIFY_WITH_TIMEOUT(anna->paths()->front().delays.size() >= 10, kPatience_ms);
        const PathReport path = anna->paths()->front();
        QVERIFY(path.roundTrip.value() > 0ns && path.roundTrip.value() < kLongestLoopback);
        QVERIFY(path.meanDelay.value() < kLongestLoopback);
        QVERIFY(!path.clockOffset);
    }

    /// What is set for the ASA is seen at both ends.
    void showsTheProbesOfTheStrategyThatRuns()
    {
        constexpr std::uint16_t kDelays = 5;
        constexpr double kProbes = 7.0;
        HeldStore::Disk disk;
        DriverWorld world{disk};
        auto& anna = world.add("Anna");
        world.run(2s);
        const auto isOfStrategy = [](const NodeBoard& board) {
            const auto paths = board.part(&NodeBoard::View::paths);
            return paths->size() == 1 && paths->front().isOfStrategy;
        };
        QVERIFY(!isOfStrategy(world.board) && !isOfStrategy(anna.board));
        StrategyChoice choice{.kind = StrategyKind::AsaFixed};
        choice.asa = {.delays = kDelays, .start = kProbes, .lowest = 1.0, .highest = 20.0};
        world.host->propose(kNoStation, fact::StrategyChosen{choice}, world.now);
        world.run(3s);
        for (const NodeBoard* board : {&world.board, &anna.board}) {
            QVERIFY(isOfStrategy(*board));
            const auto paths = board->part(&NodeBoard::View::paths);
            QCOMPARE(paths->front().delays.size(), std::size_t{kDelays});
            QCOMPARE(paths->front().probesPerSecond, std::optional{kProbes});
        }
        world.host->propose(kNoStation, fact::StrategyChosen{}, world.now);
        world.run(1s);
        QVERIFY(!isOfStrategy(world.board) && !isOfStrategy(anna.board));
    }

    void whoLeavesHasNoPath()
    {
        MemoryDisk disk;
        const auto instructor = host(disk);
        auto anna = join(*instructor, "Anna");
        QTRY_COMPARE_WITH_TIMEOUT(instructor->paths()->size(), std::size_t{1}, kPatience_ms);
        anna.reset();
        QTRY_VERIFY_WITH_TIMEOUT(instructor->paths()->empty(), kPatience_ms);
    }
};

CARINA_TEST(TestNodePaths)

} // namespace carina::node_paths_test

#include "tst_node_paths.moc"
