#include "engine/sync/loss_meter.h"

#include "engine/sync/sequence.h"

#include <algorithm>

namespace carina
{

void LossMeter::add(std::uint32_t sequence)
{
    if (!m_newest || isAfter(sequence, *m_newest)) {
        const std::uint32_t step =
            m_newest ? std::min(sequence - *m_newest, kWindow) : std::uint32_t{1};
        for (std::uint32_t back = 0; back < step; ++back)
            m_arrived.reset((sequence - back) % kWindow);
        m_span = std::min(m_span + step, kWindow);
        m_newest = sequence;
    }
    if (*m_newest - sequence < m_span)
        m_arrived.set(sequence % kWindow);
}

double LossMeter::share() const
{
    if (m_span == 0)
        return 0.0;
    return 1.0 - static_cast<double>(m_arrived.count()) / static_cast<double>(m_span);
}

} // namespace carina
