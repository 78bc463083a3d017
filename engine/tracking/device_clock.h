#pragma once

#include "engine/core/session_time.h"

#include <deque>

namespace carina
{

/// Converts times of a device's own clock to this machine's: by the least delay of the last 256
/// samples, of which the one that came quickest is held to have come at once.
///
///     local = device + min (arrived - device)
///
/// A device whose clock is set, or that is another one, is noticed by a sample that would then be
/// more than a second old: the clock begins anew with it.
class DeviceClock
{
public:
    /// The local time of a sample. @param device its time by the device's clock, from any origin
    [[nodiscard]] LocalTime local(Duration device, LocalTime arrived);

private:
    std::deque<Duration> m_delays;
};

} // namespace carina
