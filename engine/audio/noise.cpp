#include "engine/audio/noise.h"

#include "engine/core/expects.h"

namespace carina
{

Noise::Noise(std::uint64_t seed) : m_state{seed} { CARINA_EXPECTS(seed != 0); }

double Noise::next()
{
    m_state ^= m_state >> 12;
    m_state ^= m_state << 25;
    m_state ^= m_state >> 27;
    const std::uint64_t drawn = m_state * 0x2545F4914F6CDD1DULL;
    return static_cast<double>(drawn >> 11) * 0x1p-52 - 1.0;
}

} // namespace carina
