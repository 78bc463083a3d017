#include "engine/core/ended_threads.h"

#include "tests/support/test_class.h"

#include <condition_variable>
#include <cstdlib>
#include <mutex>
#include <string>
#include <sys/wait.h>
#include <unistd.h>

namespace carina::ended_threads_test
{
namespace
{

constexpr int kEnded = 7; ///< with which the programs of this test end

struct ProgramEnd {
    int status = 0;   ///< kEnded where it came to its end
    std::string said; ///< by its thread
};

/// Runs a program that gives such a thread away and then ends.
template <class Work> ProgramEnd endOfProgramWith(const Work& work)
{
    int pipeEnds[2];
    if (pipe(pipeEnds) != 0)
        return {};
    const pid_t child = fork();
    if (child == 0) {
        joinLater(
            std::jthread{[&](const std::stop_token& stopping) { work(stopping, pipeEnds[1]); }});
        std::exit(kEnded);
    }
    close(pipeEnds[1]);
    ProgramEnd end;
    char letter = 0;
    while (read(pipeEnds[0], &letter, 1) == 1)
        end.said += letter;
    close(pipeEnds[0]);
    int status = 0;
    waitpid(child, &status, 0);
    end.status = WIFEXITED(status) ? WEXITSTATUS(status) : 0;
    return end;
}

} // namespace

class TestEndedThreads : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void waitsForAThreadAtTheEndOfTheProgram()
    {
        const ProgramEnd end = endOfProgramWith([](const std::stop_token& stopping, int out) {
            std::mutex mutex;
            std::unique_lock lock{mutex};
            std::condition_variable_any{}.wait(lock, stopping, [] { return false; });
            if (write(out, "e", 1) != 1)
                std::abort();
        });
        QCOMPARE(end.status, kEnded);
        QCOMPARE(end.said, std::string{"e"});
    }

    /// As by a driver that never comes back. Without a bound this test would not come to its end.
    void endsAProgramWhoseThreadIsStuck()
    {
        const ProgramEnd end = endOfProgramWith([](const std::stop_token&, int) {
            for (;;)
                pause();
        });
        QCOMPARE(end.status, kEnded);
    }
};

CARINA_TEST(TestEndedThreads)

} // namespace carina::ended_threads_test

#include "tst_ended_threads.moc"
