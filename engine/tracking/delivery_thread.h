#pragma once

#include "engine/core/result.h"
#include "engine/core/session_time.h"

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

namespace carina
{

/// Reads the session clock; nothing while it is not yet set. Called from any thread.
using ReadSessionClock = std::function<std::optional<SessionTime>()>;

/// Calls a step on a thread of its own at the session times the step asks for. The step holds what
/// is deterministic and is tested without the thread.
class DeliveryThread
{
public:
    /// Does everything due at `now`, and says when it is next due; nothing when all is done.
    using Step = std::function<std::optional<SessionTime>(SessionTime now)>;

    DeliveryThread(ReadSessionClock clock, Step step);
    ~DeliveryThread() { stop(); }

    /// Begins; harmless while it runs. @returns TrackerFailed where no thread can be had.
    [[nodiscard]] Result<void> start();

    /// Ends; on return the step is not running and is not called any more.
    void stop();

private:
    void run(const std::stop_token& stopping);

    ReadSessionClock m_clock;
    Step m_step;
    std::mutex m_mutex;
    std::condition_variable_any m_wake;
    std::jthread m_thread;
};

} // namespace carina
