#include "engine/scoring/motion/motion_meter.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace carina
{

void MotionMeter::add(const PoseSample& sample)
{
    if (m_last && sample.time - *m_last < kLeastStep)
        return;
    if (m_last)
        m_sum.watched += sample.time - *m_last;
    m_last = sample.time;
    if (sample.validity == Validity::Lost)
        return;
    if (!m_window.empty() && sample.time - m_window.back().time > kLongestGap) {
        m_window.clear();
        m_measured.reset();
    }
    m_window.push_back({sample.time, sample.X_FO.translation()});
    while (m_window.size() > 1 && sample.time - m_window[1].time >= kWindow)
        m_window.pop_front();
    const Duration span = sample.time - m_window.front().time;
    if (span >= kWindow && m_window.size() >= kLeastPoints)
        measure(m_window.front().time + span / 2);
}

void MotionMeter::pause()
{
    m_window.clear();
    m_last.reset();
    m_measured.reset();
    m_p_F.reset();
}

void MotionMeter::measure(SessionTime middle)
{
    std::vector<TimedPoint> points;
    points.reserve(m_window.size());
    for (const Place& place : m_window)
        points.push_back({toSeconds(place.time - middle), place.p_F});
    const LocalMotion motion = motionAtZero(points);
    follow(motion);
    const Duration since = m_measured ? middle - *m_measured : Duration{};
    m_measured = middle;
    const double jerk = motion.j_F.norm();
    m_sum.measured += since;
    m_sum.meanAcceleration += motion.a_F.norm() * toSeconds(since);
    m_sum.meanJerk += jerk * toSeconds(since);
    m_squaredJerk += jerk * jerk * toSeconds(since);
    m_highestSpeed = std::max(m_highestSpeed, motion.v_F.norm());
    if (jerk > m_highestJerk) {
        m_highestJerk = jerk;
        m_sum.jerkiest = middle;
    }
}

void MotionMeter::follow(const LocalMotion& motion)
{
    if (!m_p_F)
        m_p_F = motion.p_F;
    const Vec3 step_F = motion.p_F - *m_p_F;
    if (metres(step_F.norm()) < kPathStep)
        return;
    m_sum.path = m_sum.path + metres(step_F.norm());
    m_sum.verticalTravel = m_sum.verticalTravel + metres(std::abs(step_F.dot(m_up_F)));
    m_p_F = motion.p_F;
}

std::optional<MotionFigures> MotionMeter::figures() const
{
    const double seconds = toSeconds(m_sum.measured);
    if (m_sum.measured < kLeastMeasured || seconds < kLeastShare * toSeconds(m_sum.watched))
        return std::nullopt;
    MotionFigures figures = m_sum;
    figures.meanAcceleration /= seconds;
    figures.meanJerk /= seconds;
    if (m_sum.path >= kPathStep)
        figures.smoothness =
            -std::log(std::pow(seconds, 3) * m_squaredJerk / (m_highestSpeed * m_highestSpeed));
    return figures;
}

} // namespace carina
