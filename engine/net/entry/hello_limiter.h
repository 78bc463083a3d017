#pragma once

#include "engine/net/entry/source_limiter.h"

#include <map>

namespace carina
{

/// Rate limit of ClientHellos with a valid cookie, because each costs the host more than its
/// sender. Each source has a burst of 128, then 100 a second: a whole class may share one address,
/// with somebody who takes what there is. All sources together have a burst of 256, then 200 a
/// second.
///
/// Where more than half of the burst of all is used up, the sources of the last 10 s have turns:
/// each of n has one ClientHello in 10 n ms, and all of them 100 a second. The other half is for
/// who comes new: it finds room, however many each of up to 400 others sends.
class HelloLimiter
{
public:
    static constexpr BurstRate kRate{128, std::chrono::milliseconds{10}};
    static constexpr BurstRate kRateOfAll{256, std::chrono::milliseconds{5}};
    /// How long a source is known as one that has turns: 1000 have one in this time.
    static constexpr Duration kRemembered = std::chrono::seconds{10};

    /// Whether a ClientHello that arrives at `now` is within the limits; counts it if so.
    [[nodiscard]] bool admits(const SourcePrefix& source, LocalTime now);

private:
    struct Source {
        LocalTime fullAgain; ///< by kRate
        LocalTime last;      ///< that was admitted
    };

    void forgetQuietSources(LocalTime now);
    /// Whether one that is known may have one more, where all want more than there is; counts it.
    [[nodiscard]] bool hasTurn(const Source& source, LocalTime now);

    std::map<SourcePrefix, Source> m_sources;
    LocalTime m_allFullAgain = LocalTime::min(); // by kRateOfAll
    LocalTime m_turnsFullAgain = LocalTime::min();
    LocalTime m_nextForget = LocalTime::min();
};

} // namespace carina
