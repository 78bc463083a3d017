#pragma once

#include "engine/core/session_time.h"

#include <algorithm>

namespace carina
{

/// When the facts that arrived at a client are to be acknowledged.
///
/// A fact that came alone and in its turn waits for what goes to the host anyway, at most kLongest,
/// so that a session of many costs the host a datagram less for each fact and participant. What
/// tells of a loss, or lets the host send more, does not wait.
class FactAcknowledgement
{
public:
    /// Half of the time after which a host sends a fact again, beside the round trip.
    static constexpr Duration kLongest = std::chrono::milliseconds{25};
    /// So many facts are acknowledged at once.
    static constexpr std::size_t kAtOnce = 8;

    /// A fact arrived. @param next how many facts came to be the next ones in order by it: none by
    /// one that was here already or came early
    void arrived(std::size_t next, LocalTime now)
    {
        m_owed += next;
        const bool waits = next == 1 && m_owed < kAtOnce;
        m_due = std::min(m_due, waits ? now + kLongest : now);
    }
    /// When an acknowledgement is to be sent alone; LocalTime::max() where none is owed.
    [[nodiscard]] LocalTime due() const { return m_due; }
    [[nodiscard]] bool isOwed() const { return m_due != LocalTime::max(); }
    void given() { *this = {}; }

private:
    std::size_t m_owed = 0; ///< facts in order since the last acknowledgement
    LocalTime m_due = LocalTime::max();
};

} // namespace carina
