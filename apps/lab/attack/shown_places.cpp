#include "apps/lab/attack/shown_places.h"

#include <algorithm>
#include <cmath>

namespace carina::lab
{

void ShownPlaces::heard(const PoseSample& sample, SessionTime now)
{
    const auto before = std::exchange(m_newest, sample);
    if (!before)
        return;
    const double way = (sample.X_FO.translation() - before->X_FO.translation()).norm();
    if (way <= kFastestHand * toSeconds(sample.time - before->time))
        return;
    ++m_jumps;
    m_blended = now + kBlended;
    std::erase_if(m_shown, [&](const Shown& shown) { return shown.time >= before->time; });
}

void ShownPlaces::shown(SessionTime now, const Vec3& p_A, const Truth& truth)
{
    if (now >= m_nextShown && now >= m_blended) {
        m_nextShown = now + kShownInterval;
        m_shown.push_back({now, p_A});
    }
    for (; !m_shown.empty() && m_shown.front().time + kArrived < now; m_shown.pop_front()) {
        const auto was = truth(m_shown.front().time);
        if (!was)
            continue;
        const double apart = inMillimetres(metres((*was - m_shown.front().p_A).norm()));
        m_squares_mm2 += apart * apart;
        ++m_places;
    }
}

double ShownPlaces::drift_mm() const
{
    return m_places > 0 ? std::sqrt(m_squares_mm2 / double(m_places)) : 0.0;
}

} // namespace carina::lab
