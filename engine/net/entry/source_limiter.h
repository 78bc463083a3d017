#pragma once

#include "engine/net/entry/burst_rate.h"

#include <array>
#include <cstdint>
#include <map>

namespace carina
{

/// Source of datagrams for rate limiting: an IPv4 address or the first 64 bits of an IPv6 address.
using SourcePrefix = std::array<std::uint8_t, 16>;

/// Rate limit of what each source may ask for: unless another is given, a burst of 128, then 50 a
/// second, as a whole class may share one address. There is no limit for all of them: addresses
/// that are forged use up nobody's share.
class SourceLimiter
{
public:
    static constexpr BurstRate kRate{128, std::chrono::milliseconds{20}};
    /// Most sources stored; all others share one limit.
    static constexpr std::size_t kMostSources = 1024;

    explicit SourceLimiter(BurstRate rate = kRate) : m_rate{rate} {}

    /// Whether one more that arrives at `now` is within the limit; counts it if so.
    [[nodiscard]] bool admits(const SourcePrefix& source, LocalTime now);

private:
    void forgetQuietSources(LocalTime now);

    BurstRate m_rate;
    std::map<SourcePrefix, LocalTime> m_fullAgain; // by m_rate
    LocalTime m_othersFullAgain = LocalTime::min();
};

} // namespace carina
