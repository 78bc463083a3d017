#include "engine/display/time_of_light.h"

#include <algorithm>
#include <vector>

namespace carina
{

void TimeOfLight::frameTook(Duration drawing)
{
    m_latest.push_back(drawing);
    if (m_latest.size() > kKept)
        m_latest.pop_front();
}

LocalTime TimeOfLight::of(LocalTime begun, double refreshRate)
{
    const bool known = refreshRate >= 20.0 && refreshRate <= 1000.0;
    const Duration halfRefresh = fromSeconds(0.5 / (known ? refreshRate : kUsualRefreshRate));
    m_last = std::max(m_last, begun + std::min(medianDrawing() + halfRefresh, kFarthest));
    return m_last;
}

Duration TimeOfLight::medianDrawing() const
{
    if (m_latest.empty())
        return Duration::zero();
    std::vector<Duration> sorted{m_latest.begin(), m_latest.end()};
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    return *middle;
}

} // namespace carina
