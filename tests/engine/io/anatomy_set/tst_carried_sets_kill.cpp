#include "engine/io/anatomy_set/carried_sets.h"

#include "tests/engine/io/anatomy_set/carried_set_files.h"
#include "tests/support/test_class.h"

#include <QTemporaryDir>

#include <array>
#include <csignal>
#include <random>
#include <sys/wait.h>
#include <unistd.h>

namespace carina::carried_sets_kill_test
{
namespace
{

constexpr int kKills = 40;
constexpr qsizetype kPiece = 1000;

/// Goes on with the set until all of it is there, and ends well. Writes a byte for each piece.
[[noreturn]] void receive(const std::filesystem::path& cache, const CarriedSet& set,
                          const QByteArray& bytes, int progress)
{
    const auto partial = CarriedSets{cache}.resume(set);
    if (!partial || !*partial)
        _exit(1);
    for (auto at = qsizetype((*partial)->bytes()); at < bytes.size(); at += kPiece)
        if (!(*partial)->append(test::bytesOf(bytes.mid(at, kPiece)))
            || write(progress, "p", 1) != 1)
            _exit(1);
    _exit((*partial)->finish() ? 0 : 1);
}

/// @returns how the process ended that was killed after so many pieces, or ended before.
int statusOfKilled(const std::filesystem::path& cache, const CarriedSet& set,
                   const QByteArray& bytes, int pieces)
{
    std::array<int, 2> progress{};
    if (pipe(progress.data()) != 0)
        return -1;
    const pid_t receiver = fork();
    if (receiver == 0)
        receive(cache, set, bytes, progress[1]);
    close(progress[1]);
    char piece = 0;
    while (pieces > 0 && read(progress[0], &piece, 1) == 1)
        --pieces;
    kill(receiver, SIGKILL);
    int status = 0;
    waitpid(receiver, &status, 0);
    close(progress[0]);
    return status;
}

} // namespace

/// Processes that are killed with SIGKILL while a set comes.
class TestCarriedSetsKill : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isWholeOrNotThereWheneverAReceiverIsKilled()
    {
        QTemporaryDir folder;
        const std::filesystem::path root = folder.path().toStdString();
        test::importInto(root / "host", test::carriedSample(20'000));
        const auto set = CarriedSets{root / "host"}.prepare(test::kSetHash);
        QVERIFY(set);
        const QByteArray bytes = test::contentOf(CarriedSets{root / "host"}.file(set->digest));
        const CarriedSets here{root / "here"};
        std::mt19937 random{7};
        // More than there are: some receivers come to their end.
        const auto mostPieces = static_cast<std::uint32_t>(bytes.size() / kPiece + 10);
        int killed = 0;
        int wholes = 0;
        for (int i = 0; i < kKills; ++i) {
            const int status =
                statusOfKilled(root / "here", *set, bytes, static_cast<int>(random() % mostPieces));
            killed += WIFSIGNALED(status) ? 1 : 0;
            QVERIFY(WIFSIGNALED(status) || WEXITSTATUS(status) == 0);
            if (!std::filesystem::exists(here.file(set->digest)))
                continue;
            QVERIFY(here.load(set->digest, test::kSetHash)); // whoever finds it finds it whole
            std::filesystem::remove(here.file(set->digest));
            ++wholes;
        }
        QVERIFY(killed > kKills / 4);
        QVERIFY(wholes > 0);
    }
};

CARINA_TEST(TestCarriedSetsKill)

} // namespace carina::carried_sets_kill_test

#include "tst_carried_sets_kill.moc"
