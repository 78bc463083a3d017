#pragma once

#include "engine/core/session_time.h"

#include <QSocketNotifier>

#include <functional>
#include <optional>

namespace carina
{

/// A one-shot timer that calls back from this thread's event loop at a time of CLOCK_MONOTONIC,
/// accurate to some tens of microseconds. QTimer has a resolution of 1 ms.
class PreciseTimer
{
public:
    /// @pre a file descriptor is available.
    explicit PreciseTimer(std::function<void()> onTime);
    ~PreciseTimer();
    PreciseTimer(const PreciseTimer&) = delete;
    PreciseTimer& operator=(const PreciseTimer&) = delete;

    /// Replaces the time set before; a time in the past calls back immediately.
    void setTo(LocalTime machine);

private:
    std::function<void()> m_onTime;
    int m_file;
    std::optional<QSocketNotifier> m_notifier;
};

} // namespace carina
