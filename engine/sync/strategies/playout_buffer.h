#pragma once

#include "engine/core/session_time.h"
#include "engine/sync/wire/event_cpo.h"

#include <deque>

namespace carina
{

/// Snapshots of one object, drawn late by as much as their jitter asks for.
///
/// With o = arrival here - time of the snapshot on the sender's clock (delay and clock offset
/// together) over the last kWindow snapshots, what is drawn at local time t is the object at the
/// sender's time
///
///     t - (q95(o) + kPeriod)
///
/// the 95th percentile, so that the snapshot after that time is mostly there, and one period to
/// interpolate over. The delay follows at 10 % of the elapsed time, so that motion is at most that
/// much too fast or slow. Beyond the newest snapshot the object stands still.
class PlayoutBuffer
{
public:
    static constexpr std::size_t kWindow = 120;
    static constexpr Duration kPeriod{16'666'667};
    static constexpr int kFollowDivisor = 10;

    /// @param sent on the sender's clock
    void add(SessionTime sent, const ActedPose& acted, LocalTime now);
    /// @pre add() was called.
    [[nodiscard]] ActedPose at(LocalTime t) const;
    /// Local time less the sender's time that is drawn.
    [[nodiscard]] Duration playout() const { return m_playout; }

private:
    struct Snapshot {
        SessionTime sent;
        ActedPose acted;
    };

    void follow(LocalTime now);

    std::deque<Duration> m_offsets;   // the newest last
    std::deque<Snapshot> m_snapshots; // ascending in time
    Duration m_playout{};
    LocalTime m_lastFollowed{};
};

} // namespace carina
