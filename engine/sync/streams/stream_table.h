#pragma once

#include "engine/sync/wire/stream_cpo.h"

#include <optional>
#include <unordered_map>

namespace carina
{

/// One stream sample with the fields of its group.
struct StreamSample {
    ParticipantId owner;
    std::uint16_t epoch = 0;
    StationId station;
    StreamCpo cpo;
};

/// The shared objects and the newest sample of each. A sample is newer by the owner's epoch, then
/// by its sequence number.
class StreamTable
{
public:
    /// Largest difference between the time of a sample and the present.
    static constexpr Duration kLargestAge = std::chrono::seconds{10};

    void share(ObjectId object, ParticipantId owner);
    void clear() { m_objects.clear(); }

    /// Whether the sample is used: the object is shared, the sample comes from its owner, is within
    /// kLargestAge of `now`, and is newer than the last accepted one. If so, it is stored as the
    /// newest.
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

/// One group per owner, epoch and station, split where a datagram is full: at kStreamsPerGroup
/// without forms.
/// @pre the times of the samples lie within kGroupTimeSpan of each other.
[[nodiscard]] std::vector<StreamGroup> groupStreams(const std::vector<StreamSample>& samples);

} // namespace carina
