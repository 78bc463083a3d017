#include "engine/io/site/site_file.h"

#include "tests/engine/io/site/site_sample.h"
#include "tests/support/test_class.h"

#include <QTemporaryDir>

#include <array>
#include <csignal>
#include <random>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace carina::site_file_kill_test
{
namespace
{

constexpr int kKills = 25;
constexpr int kMostWrites = 5;
constexpr int kMostYields = 400; // about as long as a write takes

/// Writes site after site until it is killed, and a byte to the pipe before each.
[[noreturn]] void writeForEver(const std::filesystem::path& file, int pipeEnd)
{
    Site site = test::wholeSite();
    for (int i = 0;; ++i) {
        site.tracker = "number " + std::to_string(i);
        const bool told = write(pipeEnd, "w", 1) == 1;
        if (!told || !writeSiteFile(file, site))
            _exit(1);
    }
}

/// Lets a process write that often, and kills it somewhere in the next write.
/// @returns whether it ran until it was killed.
bool killAWriter(const std::filesystem::path& file, int writes, int yields)
{
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0)
        return false;
    const pid_t writer = fork();
    if (writer == 0)
        writeForEver(file, ends[1]);
    char byte = 0;
    for (int i = 0; i <= writes && read(ends[0], &byte, 1) == 1;)
        ++i;
    for (int i = 0; i < yields; ++i)
        std::this_thread::yield();
    kill(writer, SIGKILL);
    int status = 0;
    const bool ended = waitpid(writer, &status, 0) == writer;
    close(ends[0]);
    close(ends[1]);
    return ended && WIFSIGNALED(status);
}

} // namespace

/// Processes that are killed with SIGKILL while they write.
class TestSiteFileKill : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isWholeWheneverAWriterIsKilled()
    {
        QTemporaryDir folder;
        const std::filesystem::path file =
            (folder.path() + QStringLiteral("/site.json")).toStdString();
        QVERIFY(writeSiteFile(file, test::wholeSite()));
        std::mt19937 random{7};
        std::uniform_int_distribution<int> writes{0, kMostWrites};
        std::uniform_int_distribution<int> yields{0, kMostYields};
        int renewed = 0;
        for (int i = 0; i < kKills; ++i) {
            QVERIFY(killAWriter(file, writes(random), yields(random)));
            const auto site = readSiteFile(file);
            QVERIFY2(site.has_value(), site ? "" : site.error().detail.c_str());
            QCOMPARE(site->touched.size(), 4U);
            renewed += site->tracker != "simulated" ? 1 : 0;
        }
        QVERIFY(renewed > 0);
    }
};

CARINA_TEST(TestSiteFileKill)

} // namespace carina::site_file_kill_test

#include "tst_site_file_kill.moc"
