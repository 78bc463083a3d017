#pragma once

#include "engine/net/entry/burst_rate.h"
#include "engine/net/secure/endpoint.h"

#include <map>

namespace carina
{

/// Rate limit of ClientHellos with a valid cookie for each address and port: a burst of 8, then 2 a
/// second, so that one port takes at most a sixteenth of what its address has at once, and a
/// fiftieth afterwards. A client begins each handshake from a port of its own.
class EndpointLimiter
{
public:
    static constexpr BurstRate kRate{8, std::chrono::milliseconds{500}};

    /// Whether one more is within the limit.
    [[nodiscard]] bool hasRoom(const Endpoint& from, LocalTime now) const;
    /// Counts one that was within all limits: only these take up memory, for 4 s at most.
    void count(const Endpoint& from, LocalTime now);

private:
    std::map<Endpoint, LocalTime> m_fullAgain; // by kRate
    LocalTime m_nextForget = LocalTime::min();
};

} // namespace carina
