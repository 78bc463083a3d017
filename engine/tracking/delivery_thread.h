#pragma once

#include "engine/core/result.h"
#include "engine/core/session_time.h"
#include "engine/tracking/stoppable_thread.h"

#include <functional>
#include <optional>

namespace carina
{

/// Reads the session clock; returns nothing while it is not yet set. Called from any thread.
using ReadSessionClock = std::function<std::optional<SessionTime>()>;

/// Calls a step function on its own thread, at the session times that the step returns or earlier.
/// The step contains the deterministic logic and is tested without the thread.
class DeliveryThread
{
public:
    /// Does what is due at `now`. @returns when it is due next; nothing to end the thread.
    using Step = std::function<std::optional<SessionTime>(SessionTime now)>;

    DeliveryThread(ReadSessionClock clock, Step step);

    /// Starts the thread; no effect while it runs. @returns TrackerFailed where that fails.
    [[nodiscard]] Result<void> start() { return m_thread.start(); }

    /// Stops the thread; on return the step is not running and will not be called any more.
    void stop() { m_thread.stop(); }

private:
    void run(const std::stop_token& stopping);

    ReadSessionClock m_clock;
    Step m_step;
    StoppableThread m_thread; // last: ends before what it uses
};

} // namespace carina
