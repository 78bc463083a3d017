#include "engine/tracking/stoppable_thread.h"

#include "engine/core/prompt_thread.h"

#include <system_error>

namespace carina
{

Result<void> StoppableThread::start()
{
    if (m_thread.joinable())
        return {};
    Result<void> started;
    startPromptly([&] {
        try {
            m_thread = std::jthread{[this](const std::stop_token& stopping) { m_work(stopping); }};
        } catch (const std::system_error& error) {
            started = fail(Errc::TrackerFailed, error.what());
        }
    });
    return started;
}

void StoppableThread::stop()
{
    m_thread.request_stop();
    if (m_thread.joinable())
        m_thread.join();
}

void StoppableThread::rest(Duration duration, const std::stop_token& stopping)
{
    std::unique_lock lock{m_mutex};
    m_wake.wait_for(lock, stopping, duration, [] { return false; });
}

} // namespace carina
