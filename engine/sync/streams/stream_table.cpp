#include "engine/sync/streams/stream_table.h"

#include "engine/sync/wire/cpo_codec.h"
#include "engine/sync/wire/sequence.h"

#include <map>
#include <tuple>

namespace carina
{

void StreamTable::share(ObjectId object, ParticipantId owner)
{
    Object& entry = m_objects[object];
    if (entry.owner != owner)
        entry = Object{owner, std::nullopt};
}

bool StreamTable::accept(const StreamSample& sample, SessionTime now)
{
    const auto found = m_objects.find(sample.cpo.object);
    if (found == m_objects.end() || found->second.owner != sample.owner
        || std::chrono::abs(sample.cpo.time - now) > kLargestAge)
        return false;
    std::optional<Newest>& newest = found->second.newest;
    if (newest && isAfter(newest->epoch, sample.epoch))
        return false;
    if (newest && newest->epoch == sample.epoch && !isAfter(sample.cpo.sequence, newest->sequence))
        return false;
    newest = Newest{sample.epoch, sample.cpo.sequence};
    return true;
}

std::vector<StreamGroup> groupStreams(const std::vector<StreamSample>& samples)
{
    std::vector<StreamGroup> groups;
    using Heading = std::tuple<ParticipantId, std::uint16_t, StationId>;
    struct Last {
        std::size_t group;
        std::size_t bytes = 0;
    };
    std::map<Heading, Last> last; // of each
    for (const StreamSample& sample : samples) {
        const Heading heading{sample.owner, sample.epoch, sample.station};
        Last& to = last.try_emplace(heading, Last{groups.size()}).first->second;
        const std::size_t bytes = bytesOf(sample.cpo);
        if (to.bytes + bytes > kStreamsPerGroup * kStreamCpoBytes)
            to = Last{groups.size()};
        if (to.group == groups.size())
            groups.push_back({sample.owner, sample.epoch, sample.station, {}});
        groups[to.group].streams.push_back(sample.cpo);
        to.bytes += bytes;
    }
    return groups;
}

} // namespace carina
