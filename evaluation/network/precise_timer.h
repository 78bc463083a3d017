#pragma once

#include "engine/core/session_time.h"

#include <QSocketNotifier>

#include <functional>
#include <optional>

namespace carina
{

/// Calls from this thread's event loop when the machine's CLOCK_MONOTONIC shows a time, to some
/// tens of microseconds. QTimer knows whole milliseconds only.
class PreciseTimer
{
public:
    /// @pre the process may open one more file.
    explicit PreciseTimer(std::function<void()> onTime);
    ~PreciseTimer();
    PreciseTimer(const PreciseTimer&) = delete;
    PreciseTimer& operator=(const PreciseTimer&) = delete;

    /// In place of the time it was set to before; one that is past calls at once.
    void setTo(LocalTime machine);

private:
    std::function<void()> m_onTime;
    int m_file;
    std::optional<QSocketNotifier> m_notifier;
};

} // namespace carina
