#include "engine/scoring/course/blade_samples.h"

namespace carina
{

std::vector<PoseSample> BladeSamples::inMouthUntil(SessionTime t)
{
    std::vector<PoseSample> inMouth;
    for (; !m_waiting.empty() && m_waiting.front().time <= t; m_waiting.pop_front())
        if (m_in && m_waiting.front().time >= *m_in)
            inMouth.push_back(m_waiting.front());
    return inMouth;
}

std::vector<PoseSample> BladeSamples::bladeOut(SessionTime at)
{
    std::vector<PoseSample> last = inMouthUntil(at);
    m_in.reset();
    return last;
}

} // namespace carina
