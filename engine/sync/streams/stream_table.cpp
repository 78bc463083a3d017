#include "engine/sync/streams/stream_table.h"

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
    std::map<Heading, std::size_t> last; // group of each
    for (const StreamSample& sample : samples) {
        const Heading heading{sample.owner, sample.epoch, sample.station};
        const auto [found, isNew] = last.try_emplace(heading, groups.size());
        if (!isNew && groups[found->second].streams.size() >= kStreamsPerGroup)
            found->second = groups.size();
        if (found->second == groups.size())
            groups.push_back({sample.owner, sample.epoch, sample.station, {}});
        groups[found->second].streams.push_back(sample.cpo);
    }
    return groups;
}

} // namespace carina
