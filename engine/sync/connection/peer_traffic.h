#pragma once

#include "engine/core/session_time.h"

#include <cstdint>

namespace carina
{

/// A rate, smoothed exponentially: amounts count less, the longer ago they came, with a time
/// constant of one second. Steady arrivals are shown in full after five seconds.
class RateMeter
{
public:
    static constexpr double kTimeConstant_s = 1.0;

    void add(double amount, LocalTime now);
    [[nodiscard]] double perSecond(LocalTime now) const;

private:
    double m_perSecond = 0.0; ///< at m_at
    LocalTime m_at{};
};

/// What a participant's program sent since it came in.
struct PeerTraffic {
    RateMeter bytes;
    RateMeter samples;         ///< of streams
    std::uint64_t facts = 0;   ///< that became of its proposals
    std::uint64_t refused = 0; ///< proposals, samples and datagrams that were not taken
};

} // namespace carina
