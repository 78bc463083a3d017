#include "engine/core/ended_threads.h"
#include "tests/engine/core/ended_child.h"
#include "tests/support/test_class.h"

#include <condition_variable>
#include <cstdlib>
#include <mutex>
#include <string>
#include <unistd.h>

/// Asked by LeakSanitizer before it looks for leaks at a program's end. A child of fork() lacks the
/// other threads' stacks, and what only these knew of looks lost in it.
extern "C" int __lsan_is_turned_off(); // NOLINT(bugprone-reserved-identifier): its name
extern "C" int __lsan_is_turned_off() { return carina::test::isEndingChild ? 1 : 0; }

namespace carina::ended_threads_test
{
namespace
{

constexpr int kEnded = 7; ///< with which the programs of this test end

/// Runs a program that gives such a thread away and then ends.
template <class Work> test::EndedChild endOfProgramWith(const Work& work)
{
    return test::endOfChild([&work](int out) {
        joinLater(std::jthread{[&](const std::stop_token& stopping) { work(stopping, out); }});
        std::exit(kEnded);
    });
}

} // namespace

class TestEndedThreads : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void waitsForAThreadAtTheEndOfTheProgram()
    {
        const test::EndedChild end = endOfProgramWith([](const std::stop_token& stopping, int out) {
            std::mutex mutex;
            std::unique_lock lock{mutex};
            std::condition_variable_any{}.wait(lock, stopping, [] { return false; });
            if (write(out, "e", 1) != 1)
                std::abort();
        });
        QVERIFY(WIFEXITED(end.status) && WEXITSTATUS(end.status) == kEnded);
        QCOMPARE(end.said, std::string{"e"});
    }

    /// As by a driver that never comes back. Without a bound this test would not come to its end.
    void endsAProgramWhoseThreadIsStuck()
    {
        const test::EndedChild end = endOfProgramWith([](const std::stop_token&, int) {
            for (;;)
                pause();
        });
        QVERIFY(WIFEXITED(end.status) && WEXITSTATUS(end.status) == kEnded);
    }
};

CARINA_TEST(TestEndedThreads)

} // namespace carina::ended_threads_test

#include "tst_ended_threads.moc"
