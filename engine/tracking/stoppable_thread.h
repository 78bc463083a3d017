#pragma once

#include "engine/core/result.h"
#include "engine/core/session_time.h"

#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

namespace carina
{

/// A thread that can be stopped while it waits.
class StoppableThread
{
public:
    /// Works until it is to stop, or is done; waits by rest() only.
    using Work = std::function<void(const std::stop_token& stopping)>;

    explicit StoppableThread(Work work) : m_work{std::move(work)} {}
    ~StoppableThread() { stop(); }

    /// No effect while it runs. @returns TrackerFailed where there is no thread.
    [[nodiscard]] Result<void> start();

    /// On return the work is not running and will not be called any more.
    void stop();

    /// From the work: waits so long, or until it is to stop.
    void rest(Duration duration, const std::stop_token& stopping);

private:
    Work m_work;
    std::mutex m_mutex;
    std::condition_variable_any m_wake;
    std::jthread m_thread; // last: ends before what it uses
};

} // namespace carina
