#pragma once

#include "engine/core/session_time.h"

#include <algorithm>
#include <optional>

namespace carina
{

/// A rate limit whose whole state is one point in time, which its user keeps: when the full burst
/// is available again (the generic cell rate algorithm). A burst of intervals before, nothing is.
struct BurstRate {
    int burst;         ///< how many are allowed at once
    Duration interval; ///< then one each

    /// When the full burst is available again if one more comes at `now`; nothing where that would
    /// be one too many.
    [[nodiscard]] std::optional<LocalTime> withOneMore(LocalTime fullAgain, LocalTime now) const
    {
        const LocalTime next = std::max(fullAgain, now) + interval;
        return next <= now + burst * interval ? std::optional{next} : std::nullopt;
    }
};

} // namespace carina
