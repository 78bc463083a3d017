#include "engine/tracking/breath_detector.h"

#include "engine/core/expects.h"

#include <algorithm>
#include <cmath>

namespace carina
{

double BreathDetector::motion() const { return std::max(m_motion, kLeastMotion / kShownShare); }

std::optional<SessionTime> BreathDetector::add(SessionTime t, double height)
{
    CARINA_EXPECTS(std::isfinite(height));
    if (!m_last) {
        m_lowest = height;
        m_last = t;
        m_begun = t;
        return std::nullopt;
    }
    if (t <= *m_last)
        return std::nullopt;
    m_last = t;
    forgetAfterSilence(t);
    if (!m_isRising)
        return rise(t, height);
    m_highest = std::max(m_highest, height);
    if (height < m_highest - kShownShare * motion()) {
        const double moved = m_highest - m_lowest;
        m_motion = m_lastMotion > 0.0 ? std::min(m_lastMotion, moved) : moved;
        m_lastMotion = moved;
        m_isRising = false;
        m_isAboveFoot = false;
        m_lowest = height;
    }
    return std::nullopt;
}

void BreathDetector::forgetAfterSilence(SessionTime t)
{
    if (t - m_begun <= kForgetting)
        return;
    m_motion = 0.0;
    m_lastMotion = 0.0;
}

std::optional<SessionTime> BreathDetector::rise(SessionTime t, double height)
{
    if (height <= m_lowest) {
        m_lowest = height;
        m_isAboveFoot = false;
        return std::nullopt;
    }
    const double risen = height - m_lowest;
    const bool isAbove = risen >= kFootShare * motion();
    if (isAbove && !m_isAboveFoot)
        m_foot = t;
    m_isAboveFoot = isAbove;
    if (risen < kShownShare * motion())
        return std::nullopt;
    m_isRising = true;
    m_highest = height;
    m_begun = t;
    constexpr double kBack = kFootShare / (kShownShare - kFootShare);
    return m_foot - fromSeconds(kBack * toSeconds(t - m_foot));
}

} // namespace carina
