#include "engine/net/node/host_clock.h"

#include "engine/core/clock_shift.h"

#include <fstream>

namespace carina
{
namespace
{

// Between 13 and 26 days: no reading of the session clock is taken for one of another clock.
constexpr Duration kEarliestEpoch{std::int64_t{1} << 50};
constexpr std::uint64_t kEpochSpread = std::uint64_t{1} << 50;

} // namespace

std::string readBootId()
{
    std::ifstream file{"/proc/sys/kernel/random/boot_id"};
    std::string id;
    std::getline(file, id);
    return id;
}

bool contradictsLog(const ClockAnchor& anchor, const std::string& bootId, SessionTime lastCommitted,
                    LocalTime now)
{
    // The offset at which no time has passed since the last fact, and that at which the session
    // went on ever since the machine started, by a clock that may be shifted for a test.
    const Duration started = lastCommitted.time_since_epoch();
    const Duration smallest = started - now.time_since_epoch();
    const Duration largest = started + ClockShift::kLargestOffset;
    return !bootId.empty() && anchor.bootId == bootId
           && (anchor.offset < smallest || anchor.offset > largest);
}

Duration sessionClockOffset(const std::optional<ClockAnchor>& anchor, const std::string& bootId,
                            std::optional<SessionTime> lastCommitted, LocalTime now,
                            std::uint64_t random)
{
    if (!lastCommitted)
        return kEarliestEpoch + Duration{static_cast<Duration::rep>(random % kEpochSpread)}
               - now.time_since_epoch();
    if (anchor && !bootId.empty() && anchor->bootId == bootId
        && !contradictsLog(*anchor, bootId, *lastCommitted, now))
        return anchor->offset;
    return lastCommitted->time_since_epoch() - now.time_since_epoch();
}

} // namespace carina
