#pragma once

#include "engine/core/ids.h"
#include "engine/sync/connection/token_bucket.h"
#include "engine/sync/strategies/view_comparison.h"

#include <optional>

namespace carina
{

/// What the owners of objects showed of them, on its way through the host to all others: the newest
/// of each object, at most twice in a period of comparing, however often its owner sends it; and of
/// all objects together as many as kMostPerS, who waited longest first: each goes to everybody, and
/// one person can have hundreds of objects under many names.
class ShownRelay
{
public:
    static constexpr Duration kInterval = ViewComparison::kPeriod / 2;
    static constexpr double kMostPerS = 512.0; ///< four of each of 128 objects
    static constexpr double kMostAtOnce = 128.0;
    /// How long those wait for whom there is no room.
    static constexpr Duration kWait = std::chrono::milliseconds{16};

    struct Passed {
        ShownPose shown;
        ParticipantId from; ///< the owner, who is not sent it
    };

    void take(const ShownPose& shown, ParticipantId from, LocalTime now);
    /// What is to be passed on now.
    [[nodiscard]] std::vector<Passed> takeDue(LocalTime now);
    [[nodiscard]] LocalTime nextDue() const { return m_nextDue; }

private:
    struct Entry {
        std::optional<Passed> waiting;
        LocalTime next = LocalTime::min(); ///< when it may be passed on
    };

    /// Those that may be passed on now, who waited longest first; sets when to look for the others.
    [[nodiscard]] std::vector<Entry*> ready(LocalTime now);

    std::map<ObjectId, Entry> m_entries;
    TokenBucket m_room; ///< of all
    LocalTime m_nextDue = LocalTime::max();
};

} // namespace carina
