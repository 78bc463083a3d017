#pragma once

#include "engine/core/session_time.h"

#include <deque>

namespace carina
{

/// When a frame that is begun now will be lit, on average over the screen: after the median time
/// that the latest frames took from their beginning to their swapped buffers, and half a refresh.
///
/// At most kFarthest ahead: where drawing is slower than that, a pose carried on so far would be
/// further off than one that lags, and facts would be asked for before they are known. Never
/// before the answer before, so that what is drawn never runs backwards.
class TimeOfLight
{
public:
    static constexpr std::size_t kKept = 31; ///< frames; odd, so that the median is one of them
    static constexpr Duration kFarthest = std::chrono::milliseconds{50};
    static constexpr double kUsualRefreshRate = 60.0; ///< hertz

    /// A frame took this long from its beginning to its swapped buffers.
    void frameTook(Duration drawing);

    /// @param refreshRate of the screen in hertz; the usual one where it is not from 20 to 1000,
    ///        as screens say that do not know.
    [[nodiscard]] LocalTime of(LocalTime begun, double refreshRate);

private:
    [[nodiscard]] Duration medianDrawing() const;

    std::deque<Duration> m_latest;
    LocalTime m_last = LocalTime::min();
};

} // namespace carina
