#include "engine/tracking/delivery_thread.h"

#include <algorithm>
#include <utility>

namespace carina
{

namespace
{

// The clock is read at least this often: it may be set, or corrected, while the thread waits.
constexpr Duration kLongestWait = std::chrono::milliseconds{20};

} // namespace

DeliveryThread::DeliveryThread(ReadSessionClock clock, Step step)
    : m_clock{std::move(clock)},
      m_step{std::move(step)},
      m_thread{[this](const std::stop_token& stopping) { run(stopping); }}
{
}

void DeliveryThread::run(const std::stop_token& stopping)
{
    while (!stopping.stop_requested()) {
        Duration wait = kLongestWait;
        if (const std::optional<SessionTime> now = m_clock()) {
            const std::optional<SessionTime> due = m_step(*now);
            if (!due)
                return;
            wait = std::clamp(*due - *now, Duration::zero(), kLongestWait);
        }
        m_thread.rest(wait, stopping);
    }
}

} // namespace carina
