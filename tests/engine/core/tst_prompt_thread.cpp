#include "engine/core/prompt_thread.h"
#include "tests/support/test_class.h"

#include <thread>

#include <sys/resource.h>

namespace carina::prompt_thread_test
{
namespace
{

/// Of the calling thread; the larger, the more it makes way.
int niceness() { return getpriority(PRIO_PROCESS, 0); }

int nicenessOfNewThread()
{
    int found = 0;
    std::thread{[&found] { found = niceness(); }}.join();
    return found;
}

} // namespace

class TestPromptThread : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void threadsThatAreStartedPromptlyKeepTheFirstPriority()
    {
        const int first = niceness();
        int prompt = 0;
        startPromptly([&] { prompt = nicenessOfNewThread(); });
        QCOMPARE(prompt, first); // where nothing makes way
        // In a thread of its own, since it cannot be raised again.
        std::thread{[first] {
            makeWayForPromptThreads();
            const int lowered = nicenessOfNewThread();
            QVERIFY(lowered > first);
            QCOMPARE(niceness(), lowered);
            int then = 0;
            startPromptly([&] { then = nicenessOfNewThread(); });
            QCOMPARE(then, first);
        }}.join();
        QCOMPARE(niceness(), first);
    }
};

CARINA_TEST(TestPromptThread)

} // namespace carina::prompt_thread_test

#include "tst_prompt_thread.moc"
