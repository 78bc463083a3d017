#pragma once

#include "engine/core/session_time.h"

namespace carina
{

/// The tick at which streams are sent together: 60 a second on average, also where it is served
/// late.
class StreamTick
{
public:
    static constexpr Duration kPeriod{16'666'667};

    [[nodiscard]] bool isDue(LocalTime now) const { return now >= m_next; }
    [[nodiscard]] LocalTime next() const { return m_next; }
    /// The tick was served; ticks that were missed altogether are skipped.
    void served(LocalTime now)
    {
        m_next += kPeriod;
        if (m_next <= now)
            m_next = now + kPeriod;
    }

private:
    LocalTime m_next{};
};

} // namespace carina
