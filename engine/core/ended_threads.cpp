#include "engine/core/ended_threads.h"

#include <mutex>
#include <system_error>
#include <utility>

namespace carina
{

void joinLater(std::jthread thread)
{
    if (!thread.joinable())
        return;
    thread.request_stop();
    static std::mutex mutex;
    static std::jthread last; // joins all before it, and is joined at the end of the program
    const std::lock_guard lock{mutex};
    try {
        last = std::jthread{[before = std::move(last), ended = std::move(thread)]() mutable {
            if (before.joinable())
                before.join();
            ended.join();
        }};
    } catch (const std::system_error&) {
        // There is no thread to join them: both were joined here.
    }
}

} // namespace carina
