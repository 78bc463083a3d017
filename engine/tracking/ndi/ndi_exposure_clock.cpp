#include "engine/tracking/ndi/ndi_exposure_clock.h"

#include <algorithm>

namespace carina
{
namespace
{

constexpr std::size_t kDelaysKept = 256;

} // namespace

LocalTime NdiExposureClock::exposureOf(LocalTime sent, const std::optional<Duration>& deviceTime)
{
    if (!deviceTime)
        return sent;
    m_delays.push_back(sent.time_since_epoch() - *deviceTime);
    if (m_delays.size() > kDelaysKept)
        m_delays.pop_front();
    return LocalTime{*deviceTime + *std::ranges::min_element(m_delays)};
}

} // namespace carina
