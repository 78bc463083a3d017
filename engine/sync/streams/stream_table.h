#pragma once

#include "engine/sync/wire/stream_cpo.h"

#include <optional>
#include <unordered_map>

namespace carina
{

/// One stream sample with what its group said about it.
struct StreamSample {
    ParticipantId owner;
    std::uint16_t epoch = 0;
    StationId station;
    StreamCpo cpo;
};

/// Which shared objects there are, and the newest sample of each: newest wins, by the owner's epoch
/// and then by sequence.
class StreamTable
{
public:
    /// A sample whose time is further than this from now is no present pose.
    static constexpr Duration kLargestAge = std::chrono::seconds{10};

    void share(ObjectId object, ParticipantId owner);
    void clear() { m_objects.clear(); }

    /// Whether the sample is to be used: of a shared object, from its owner, of the present, and
    /// newer than the last that was. If so it is the newest from now on.
    [[nodiscard]] bool accept(const StreamSample& sample, SessionTime now);

private:
    struct Newest {
        std::uint16_t epoch;
        std::uint16_t sequence;
    };
    struct Object {
        ParticipantId owner;
        std::optional<Newest> newest;
    };

    std::unordered_map<ObjectId, Object> m_objects;
};

/// One group per owner, epoch and station, split where one would be too long.
/// @pre the times of the samples lie within kGroupTimeSpan of each other.
[[nodiscard]] std::vector<StreamGroup> groupStreams(const std::vector<StreamSample>& samples);

} // namespace carina
