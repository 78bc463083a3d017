#pragma once

#include "engine/core/session_time.h"

#include <vector>

namespace carina
{

/// When a session stood still while its time ran on.
class Pauses
{
public:
    /// One pause, behind the last; until SessionTime::max() while it lasts.
    /// @pre from <= until, and from is not before the end of the last
    void add(SessionTime from, SessionTime until);

    /// Whether the session stands still: from the begin of a pause on, until its end.
    [[nodiscard]] bool contains(SessionTime t) const;
    /// The time from one moment to a later one without the pauses between them; 0 where it is not
    /// later.
    [[nodiscard]] Duration between(SessionTime from, SessionTime until) const;
    /// The first moment by which so much time without pauses has passed; SessionTime::max() where
    /// the last pause does not end before. @pre time is not negative
    [[nodiscard]] SessionTime after(SessionTime from, Duration time) const;

    friend bool operator==(const Pauses&, const Pauses&) = default;

private:
    struct Pause {
        SessionTime from;
        SessionTime until;

        friend bool operator==(const Pause&, const Pause&) = default;
    };

    std::vector<Pause> m_pauses; ///< by time
};

} // namespace carina
