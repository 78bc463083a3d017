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
        const Duration since = m_shown.front().time.time_since_epoch() % kPeriod;
        Phase& phase = m_phases.at(std::size_t(since * std::ssize(m_phases) / kPeriod));
        phase.squares_mm2 += apart * apart;
        ++phase.places;
    }
}

double ShownPlaces::drift_mm() const { return driftAtPhasesOf_mm(*this); }

double ShownPlaces::driftAtPhasesOf_mm(const ShownPlaces& other) const
{
    double squares_mm2 = 0.0;
    double places = 0.0;
    for (std::size_t i = 0; i < m_phases.size(); ++i) {
        if (m_phases[i].places == 0)
            continue;
        const auto as = double(other.m_phases[i].places);
        squares_mm2 += as * m_phases[i].squares_mm2 / double(m_phases[i].places);
        places += as;
    }
    return places > 0.0 ? std::sqrt(squares_mm2 / places) : 0.0;
}

std::int64_t ShownPlaces::places() const
{
    std::int64_t all = 0;
    for (const Phase& phase : m_phases)
        all += phase.places;
    return all;
}

} // namespace carina::lab
