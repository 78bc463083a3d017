#include "engine/sync/streams/host_streams.h"

#include "engine/sync/wire/cpo_codec.h"

namespace carina
{

void HostStreams::share(ObjectId object, ParticipantId owner)
{
    m_table.share(object, owner);
    m_slots.owned(object, owner);
}

bool HostStreams::take(const StreamSample& sample, const StreamSource& from, SessionTime session)
{
    const ObjectId object = sample.cpo.object;
    if (!m_table.accept(sample, session))
        return false;
    if (!from.isFirst && !m_slots.takes(object, sample.station, sample.owner, from.place))
        return false;
    m_outgoing.insert_or_assign(object, Outgoing{sample, from.isFirst});
    return true;
}

bool HostStreams::isDue(LocalTime now) const { return !m_outgoing.empty() && m_tick.isDue(now); }

LocalTime HostStreams::nextDue() const
{
    return m_outgoing.empty() ? LocalTime::max() : m_tick.next();
}

void HostStreams::chooseThinning(std::span<const StationId> stations)
{
    std::map<StationId, double> readers;
    for (const StationId station : stations)
        ++readers[station];
    const double everywhere = readers[kAllStations];
    double first = 0.0;
    double others = 0.0;
    for (const auto& [object, outgoing] : m_outgoing) {
        const auto there = readers.find(outgoing.sample.station);
        const double all = everywhere + (there == readers.end() ? 0.0 : there->second);
        (outgoing.isFirst ? first : others) += all * double(kStreamCpoBytes);
    }
    const double most = kMostBytes * toSeconds(StreamTick::kPeriod);
    m_thinning = 1;
    while (m_thinning < kLargestThinning && first + others / m_thinning > most)
        m_thinning *= 2;
}

void HostStreams::gather(std::span<const StationId> stations)
{
    ++m_ticks;
    chooseThinning(stations);
    std::vector<StreamSample> samples;
    for (auto entry = m_outgoing.begin(); entry != m_outgoing.end();) {
        if (!isTurnOf(entry->first, entry->second.isFirst)) {
            ++entry;
            continue;
        }
        samples.push_back(std::move(entry->second.sample));
        entry = m_outgoing.erase(entry);
    }
    m_groups.clear();
    for (StreamGroup& group : groupStreams(samples))
        m_groups[group.station].push_back(std::move(group));
}

std::vector<WireRecord> HostStreams::dueTo(const StreamReader& reader) const
{
    std::vector<WireRecord> records;
    const auto add = [&](const std::vector<StreamGroup>& groups) {
        for (const StreamGroup& group : groups)
            if (group.owner != reader.participant)
                records.emplace_back(group);
    };
    if (reader.station == kAllStations) {
        for (const auto& [station, groups] : m_groups)
            add(groups);
    } else if (const auto there = m_groups.find(reader.station); there != m_groups.end()) {
        add(there->second);
    }
    return records;
}

void HostStreams::served(LocalTime now)
{
    m_groups.clear();
    m_tick.served(now);
}

} // namespace carina
