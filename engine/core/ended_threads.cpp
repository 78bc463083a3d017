#include "engine/core/ended_threads.h"

#include <condition_variable>
#include <memory>
#include <mutex>
#include <system_error>
#include <utility>

namespace carina
{
namespace
{

/// The threads that were asked to stop. Of each its own thread waits for the end.
class EndedThreads
{
public:
    EndedThreads() = default;
    EndedThreads(const EndedThreads&) = delete;
    EndedThreads& operator=(const EndedThreads&) = delete;

    /// At the end of the program: those that still run then end with it.
    ~EndedThreads()
    {
        std::unique_lock lock{m_count->mutex};
        m_count->changed.wait_for(lock, kLongestAtTheEnd, [this] { return m_count->running == 0; });
    }

    void take(std::jthread thread)
    {
        add(1);
        try {
            std::thread{[count = m_count, ended = std::move(thread)]() mutable {
                ended.join();
                add(*count, -1);
            }}.detach();
        } catch (const std::system_error&) {
            add(-1); // there is no thread to join it: it was joined here
        }
    }

private:
    /// Shared by the threads that wait, which may outlive this.
    struct Count {
        std::mutex mutex;
        std::condition_variable changed;
        int running = 0;
    };

    static void add(Count& count, int more)
    {
        const std::lock_guard lock{count.mutex};
        count.running += more;
        count.changed.notify_all();
    }
    void add(int more) { add(*m_count, more); }

    std::shared_ptr<Count> m_count = std::make_shared<Count>();
};

} // namespace

void joinLater(std::jthread thread)
{
    if (!thread.joinable())
        return;
    thread.request_stop();
    static EndedThreads ended;
    ended.take(std::move(thread));
}

} // namespace carina
