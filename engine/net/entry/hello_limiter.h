#pragma once

#include "engine/core/session_time.h"

#include <array>
#include <cstdint>
#include <map>

namespace carina
{

/// Where datagrams come from as far as it can be told apart from its neighbours: an IPv4 address or
/// the first 64 bits of an IPv6 address.
using SourcePrefix = std::array<std::uint8_t, 16>;

/// Lets each source greet only so often, for each ClientHello costs the host more than its sender:
/// a burst of 128, then 50 a second, for a whole course may sit behind one address.
class HelloLimiter
{
public:
    static constexpr int kBurst = 128;
    static constexpr Duration kInterval = std::chrono::milliseconds{20};
    /// Sources known at once; beyond that all others share one allowance.
    static constexpr std::size_t kMostSources = 1024;

    /// Whether a ClientHello that came just now is to be looked at.
    [[nodiscard]] bool admits(const SourcePrefix& source, LocalTime now);

private:
    void forgetQuietSources(LocalTime now);

    // When the whole burst is allowed again; a burst before that none is.
    std::map<SourcePrefix, LocalTime> m_fullAgain;
    LocalTime m_othersFullAgain{};
};

} // namespace carina
