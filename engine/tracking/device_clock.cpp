#include "engine/tracking/device_clock.h"

#include <algorithm>

namespace carina
{
namespace
{

constexpr std::size_t kDelaysOfADevice = 256;
constexpr Duration kOldestSample = std::chrono::seconds{1};

} // namespace

LocalTime DeviceClock::local(Duration device, LocalTime arrived)
{
    const Duration delay = arrived.time_since_epoch() - device;
    m_delays.push_back(delay);
    if (m_delays.size() > kDelaysOfADevice)
        m_delays.pop_front();
    const Duration least = *std::ranges::min_element(m_delays);
    if (delay - least <= kOldestSample)
        return LocalTime{device + least};
    m_delays = {delay};
    return arrived;
}

} // namespace carina
