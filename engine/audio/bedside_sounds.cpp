#include "engine/audio/bedside_sounds.h"

#include <algorithm>

namespace carina
{

void BedsideSounds::setBreath(const BreathFlows& flows)
{
    m_right.set(flows.right, flows.rightObstruction);
    m_left.set(flows.left, flows.leftObstruction);
    m_trachea.set(flows.right + flows.left,
                  std::max(flows.rightObstruction, flows.leftObstruction));
    m_stomach.set(flows.stomach);
}

void BedsideSounds::setAuscultation(const AuscultationGains& gains)
{
    m_rightGain.aim(gains.right);
    m_leftGain.aim(gains.left);
    m_tracheaGain.aim(gains.trachea);
    m_stomachGain.aim(gains.stomach);
    m_heartGain.aim(gains.heart);
}

double BedsideSounds::nextBreath()
{
    return m_rightGain.next() * m_right.next() + m_leftGain.next() * m_left.next()
           + m_tracheaGain.next() * m_trachea.next() + m_stomachGain.next() * m_stomach.next();
}

void BedsideSounds::render(std::span<float> samples)
{
    for (float& sample : samples)
        sample = static_cast<float>(m_mixer.mix({m_oximeter.next(), m_alarm.next(), nextBreath(),
                                                 m_heartGain.next() * m_heart.next()}));
}

} // namespace carina
