#include "engine/registration/landmarks/dwell_detector.h"

#include <algorithm>

namespace carina
{
namespace
{

using Positions = std::span<const DwellDetector::Position>;

Duration covered(Positions positions)
{
    const auto count = static_cast<Duration::rep>(positions.size());
    if (count < 2)
        return {};
    return (positions.back().time - positions.front().time) * count / (count - 1);
}

/// Their mean and the largest distance from it.
/// @pre there are some
DwellPoint pointOf(Positions positions)
{
    DwellPoint point{.samples = static_cast<int>(positions.size()),
                     .from = positions.front().time,
                     .until = positions.back().time};
    for (const auto& position : positions)
        point.p_FQ += position.p_FQ / double(positions.size());
    for (const auto& position : positions)
        point.spread = std::max(point.spread, (position.p_FQ - point.p_FQ).norm());
    return point;
}

} // namespace

std::optional<DwellPoint> DwellDetector::push(SessionTime time, const Vec3& p_FQ, Validity validity)
{
    if (validity == Validity::Lost || !p_FQ.allFinite() || (m_last && time <= *m_last))
        return std::nullopt;
    if (m_last && time - *m_last > m_settings.longestGap)
        m_latest.clear();
    m_last = time;
    if (m_taken && (p_FQ - *m_taken).norm() <= m_settings.leave.si)
        return std::nullopt;
    m_taken.reset();
    m_latest.push_back({time, p_FQ});
    while (covered(Positions{m_latest}.subspan(1)) >= m_settings.hold)
        m_latest.erase(m_latest.begin());
    if (covered(m_latest) < m_settings.hold)
        return std::nullopt;
    const DwellPoint point = pointOf(m_latest);
    if (point.spread > m_settings.radius.si)
        return std::nullopt;
    m_taken = point.p_FQ;
    m_latest.clear();
    return point;
}

void DwellDetector::leave(const Vec3& p_FQ)
{
    m_taken = p_FQ;
    m_latest.clear();
}

double DwellDetector::progress() const
{
    Positions still{m_latest};
    while (!still.empty() && pointOf(still).spread > m_settings.radius.si)
        still = still.subspan(1);
    return std::min(toSeconds(covered(still)) / toSeconds(m_settings.hold), 1.0);
}

} // namespace carina
