#pragma once

#include "engine/core/session_time.h"

#include <deque>

namespace carina
{

/// Predicts when a frame that is begun now will be lit, on average over the screen: after the
/// median time of the latest frames from their beginning to their buffer swap, plus half a refresh
/// period.
///
/// The prediction is at most kFarthest ahead: a pose predicted further would have a larger error
/// than one that lags, and facts would be needed before they arrive. It is never earlier than the
/// previous one, so that the drawn time does not run backwards.
class TimeOfLight
{
public:
    static constexpr std::size_t kKept = 31; ///< frames; odd, so that the median is one of them
    static constexpr Duration kFarthest = std::chrono::milliseconds{50};
    static constexpr double kUsualRefreshRate = 60.0; ///< hertz

    /// Adds the time that a frame took from its beginning to its buffer swap.
    void frameTook(Duration drawing);

    /// The time at which a frame that was begun at `begun` will be lit.
    /// @param refreshRate of the screen, hertz; values outside 20 to 1000, which some screens
    ///                    report, are replaced by kUsualRefreshRate
    [[nodiscard]] LocalTime of(LocalTime begun, double refreshRate);

private:
    [[nodiscard]] Duration medianDrawing() const;

    std::deque<Duration> m_latest;
    LocalTime m_last = LocalTime::min();
};

} // namespace carina
