#pragma once

#include "engine/core/session_time.h"

#include <deque>
#include <optional>

namespace carina
{

/// Tells when a frame was exposed, by the clock of this computer: when its reply was sent; where
/// the device states its own time, that time by the least delay of the last 256 replies.
class NdiExposureClock
{
public:
    /// After the device was reset, its clock may have begun anew.
    void restart() { m_delays.clear(); }

    /// @param sent when the reply had arrived, less its time on the line
    [[nodiscard]] LocalTime exposureOf(LocalTime sent, const std::optional<Duration>& deviceTime);

private:
    std::deque<Duration> m_delays; ///< sent less device time, of the last replies
};

} // namespace carina
