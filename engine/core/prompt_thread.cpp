#include "engine/core/prompt_thread.h"

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <system_error>
#include <thread>

#include <sys/resource.h>

namespace carina
{
namespace
{

/// A tenth of the share of a thread that was not lowered, where there is not enough for both.
constexpr int kLowerBy = 10;

/// The thread that keeps the first priority. Never destroyed: others may start threads to the end.
class Starter
{
public:
    Starter()
    {
        std::thread{[this] { work(); }}.detach();
    }

    void run(const std::function<void()>& start)
    {
        const std::lock_guard oneAtATime{m_callers};
        std::unique_lock lock{m_mutex};
        m_start = &start;
        m_changed.notify_all();
        m_changed.wait(lock, [this] { return m_start == nullptr; });
    }

private:
    void work()
    {
        std::unique_lock lock{m_mutex};
        for (;;) {
            m_changed.wait(lock, [this] { return m_start != nullptr; });
            (*m_start)();
            m_start = nullptr;
            m_changed.notify_all();
        }
    }

    std::mutex m_callers;
    std::mutex m_mutex;
    std::condition_variable m_changed;
    const std::function<void()>* m_start = nullptr;
};

std::atomic<Starter*> starter = nullptr;
std::atomic<int> loweredTo = 0;

} // namespace

void makeWayForPromptThreads()
{
    loweredTo = getpriority(PRIO_PROCESS, 0) + kLowerBy;
    try {
        starter = new Starter;
    } catch (const std::system_error&) {
        return; // no thread can be started: all keep the same priority
    }
    makeWay();
}

void makeWay()
{
    // Of this thread alone. Where that fails, all have the same priority.
    if (starter.load() != nullptr)
        static_cast<void>(setpriority(PRIO_PROCESS, 0, loweredTo));
}

void startPromptly(const std::function<void()>& start)
{
    if (Starter* const there = starter)
        there->run(start);
    else
        start();
}

} // namespace carina
