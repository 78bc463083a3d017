#include "engine/tracking/delivery_thread.h"

#include <algorithm>
#include <system_error>
#include <utility>

namespace carina
{

namespace
{

// The clock is read at least this often: it may be set, or corrected, while the thread waits.
constexpr Duration kLongestWait = std::chrono::milliseconds{20};

} // namespace

DeliveryThread::DeliveryThread(ReadSessionClock clock, Step step)
    : m_clock{std::move(clock)}, m_step{std::move(step)}
{
}

Result<void> DeliveryThread::start()
{
    if (m_thread.joinable())
        return {};
    try {
        m_thread = std::jthread{[this](const std::stop_token& stopping) { run(stopping); }};
    } catch (const std::system_error& error) {
        return fail(Errc::TrackerFailed, error.what());
    }
    return {};
}

void DeliveryThread::stop()
{
    m_thread.request_stop();
    if (m_thread.joinable())
        m_thread.join();
}

void DeliveryThread::run(const std::stop_token& stopping)
{
    std::unique_lock lock{m_mutex};
    while (!stopping.stop_requested()) {
        Duration wait = kLongestWait;
        if (const std::optional<SessionTime> now = m_clock()) {
            const std::optional<SessionTime> due = m_step(*now);
            if (!due)
                return;
            wait = std::clamp(*due - *now, Duration::zero(), kLongestWait);
        }
        m_wake.wait_for(lock, stopping, wait, [] { return false; });
    }
}

} // namespace carina
