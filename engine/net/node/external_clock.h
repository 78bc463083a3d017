#pragma once

#include "engine/core/disciplined_clock.h"

namespace carina
{

/// Reads the system's clock, where it is disciplined, once a second.
class ExternalClock
{
public:
    static constexpr Duration kInterval = std::chrono::seconds{1};

    /// Nothing between two readings, and where readDisciplinedClock has none.
    [[nodiscard]] std::optional<ExternalTime> read(LocalTime now)
    {
        if (now < m_next)
            return std::nullopt;
        m_next = now + kInterval;
        return readDisciplinedClock();
    }

private:
    LocalTime m_next = LocalTime::min();
};

} // namespace carina
