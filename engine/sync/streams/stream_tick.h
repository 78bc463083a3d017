#pragma once

#include "engine/core/session_time.h"

namespace carina
{

/// The beat at which streams are sent together, 60 a second on average however late it is served.
class StreamTick
{
public:
    static constexpr Duration kPeriod{16'666'667};

    [[nodiscard]] bool isDue(LocalTime now) const { return now >= m_next; }
    [[nodiscard]] LocalTime next() const { return m_next; }
    /// The beat was served; beats that were missed altogether are left out.
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
