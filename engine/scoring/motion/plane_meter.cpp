#include "engine/scoring/motion/plane_meter.h"

#include <algorithm>
#include <cmath>

namespace carina
{

void PlaneMeter::add(const PoseSample& sample)
{
    if (sample.validity == Validity::Lost || (m_last && sample.time <= *m_last))
        return;
    const Duration since = m_last ? sample.time - *m_last : Duration{};
    m_last = sample.time;
    if (since > kLongestGap)
        return;
    const Vec3 x_F = sample.X_FO.rotation() * Vec3::UnitX();
    const double tilt = std::asin(std::clamp(x_F.dot(m_up_F), -1.0, 1.0));
    m_measured += since;
    m_tilt += tilt * toSeconds(since);
    m_squared += tilt * tilt * toSeconds(since);
}

std::optional<PlaneFigures> PlaneMeter::figures() const
{
    if (m_measured < kLeastMeasured)
        return std::nullopt;
    const double seconds = toSeconds(m_measured);
    const double mean = m_tilt / seconds;
    const double square = m_squared / seconds;
    return PlaneFigures{m_measured, square, radians(mean), std::max(0.0, square - mean * mean)};
}

} // namespace carina
