#include "engine/sync/strategies/delay_history.h"

#include "engine/core/expects.h"

#include <cmath>
#include <numeric>

namespace carina
{

void DelayHistory::add(Duration delay)
{
    if (isFull())
        m_delays.pop_front();
    m_delays.push_back(delay);
}

Duration DelayHistory::mean() const
{
    CARINA_EXPECTS(!m_delays.empty());
    return std::accumulate(m_delays.begin(), m_delays.end(), Duration{})
           / static_cast<Duration::rep>(m_delays.size());
}

Duration DelayHistory::sigma() const
{
    const Duration middle = mean();
    double squares = 0.0;
    for (const Duration delay : m_delays) {
        const auto apart = static_cast<double>((delay - middle).count());
        squares += apart * apart;
    }
    return Duration{std::llround(std::sqrt(squares / static_cast<double>(m_delays.size())))};
}

} // namespace carina
