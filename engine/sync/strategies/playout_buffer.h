#pragma once

#include "engine/core/session_time.h"
#include "engine/sync/wire/event_cpo.h"

#include <deque>

namespace carina
{

/// Snapshots of one object, drawn with a playout delay that adapts to their jitter.
///
/// With o = arrival here - time of the snapshot on the sender's clock (delay and clock offset
/// together) over the last kWindow snapshots, the object is drawn at local time t as it was at the
/// sender's time
///
///     t - (q95(o) + kPeriod)
///
/// with q95 the 95th percentile, so that mostly the next snapshot has arrived, and one period to
/// interpolate over. The playout delay is adjusted by at most 10 % of the elapsed time, so that
/// motion is at most 10 % too fast or slow. After the newest snapshot the object stands still.
class PlayoutBuffer
{
public:
    static constexpr std::size_t kWindow = 120;
    static constexpr Duration kPeriod{16'666'667};
    static constexpr int kFollowDivisor = 10;
    /// A snapshot that is this much earlier or later than the last ones is by another clock: the
    /// buffer begins anew.
    static constexpr Duration kAnotherClock = std::chrono::seconds{1};

    /// @param sent on the sender's clock
    void add(SessionTime sent, const ActedPose& acted, LocalTime now);
    /// @pre add() was called.
    [[nodiscard]] ActedPose at(LocalTime t) const;
    /// The playout delay: local time less the sender's time that is drawn.
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
