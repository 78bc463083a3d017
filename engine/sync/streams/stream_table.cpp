#include "engine/sync/streams/stream_table.h"

#include "engine/sync/wire/sequence.h"

#include <algorithm>

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
    for (const StreamSample& sample : samples) {
        auto group = std::ranges::find_if(groups, [&](const StreamGroup& g) {
            return g.owner == sample.owner && g.epoch == sample.epoch && g.station == sample.station
                   && g.streams.size() < kStreamsPerGroup;
        });
        if (group == groups.end())
            group = groups.insert(group, {sample.owner, sample.epoch, sample.station, {}});
        group->streams.push_back(sample.cpo);
    }
    return groups;
}

} // namespace carina
