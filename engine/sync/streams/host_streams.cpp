#include "engine/sync/streams/host_streams.h"

#include "engine/sync/wire/cpo_codec.h"

#include <algorithm>

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
    Outgoing& outgoing = m_outgoing[object];
    m_waiting += outgoing.newest ? 0 : 1;
    outgoing.newest = sample;
    outgoing.owner = sample.owner;
    outgoing.isFirst = from.isFirst;
    return true;
}

void HostStreams::leave(ParticipantId participant)
{
    m_slots.leave(participant);
    m_waiting -= static_cast<std::size_t>(std::erase_if(m_outgoing, [&](const Entry& entry) {
        return entry.second.owner == participant && entry.second.newest;
    }));
    std::erase_if(m_outgoing,
                  [&](const Entry& entry) { return entry.second.owner == participant; });
}

bool HostStreams::isDue(LocalTime now) const { return m_waiting > 0 && m_tick.isDue(now); }

LocalTime HostStreams::nextDue() const { return m_waiting > 0 ? m_tick.next() : LocalTime::max(); }

std::vector<HostStreams::Entry*> HostStreams::inTurn()
{
    std::vector<Entry*> waiting;
    for (Entry& entry : m_outgoing)
        if (entry.second.newest)
            waiting.push_back(&entry);
    std::ranges::stable_sort(waiting, {}, [](const Entry* entry) {
        return std::pair{!entry->second.isFirst, entry->second.wentOut};
    });
    return waiting;
}

void HostStreams::earn(LocalTime now)
{
    // A tick that was missed is made up for, and what was not used is not saved up.
    constexpr Duration kLongest = 2 * StreamTick::kPeriod;
    const double most = kMostBytes * toSeconds(kLongestWait);
    const Duration since = std::min(now - std::exchange(m_earnedUntil, now), kLongest);
    m_mayGoOut = std::clamp(m_mayGoOut, -most, 0.0) + kMostBytes * toSeconds(since);
}

void HostStreams::gather(std::span<const StationId> stations, LocalTime now)
{
    earn(now);
    std::map<StationId, double> readers;
    for (const StationId station : stations)
        ++readers[station];
    const double everywhere = readers[kAllStations];
    // A tick that comes a little early counts as the one that it is.
    const LocalTime waitsSince = now - kLongestWait + StreamTick::kPeriod / 2;
    const std::vector<Entry*> waiting = inTurn();
    const auto others =
        std::ranges::count_if(waiting, [](const Entry* entry) { return !entry->second.isFirst; });
    auto share = (others + kLongestWaitInTicks - 1) / kLongestWaitInTicks;
    std::vector<StreamSample> samples;
    for (Entry* entry : waiting) {
        Outgoing& outgoing = entry->second;
        const auto there = readers.find(outgoing.newest->station);
        const double bytes = double(bytesOf(outgoing.newest->cpo))
                             * (everywhere + (there == readers.end() ? 0.0 : there->second));
        const bool waitedLong = outgoing.wentOut != LocalTime{} && outgoing.wentOut <= waitsSince;
        const bool goes = outgoing.isFirst || waitedLong || share > 0 || m_mayGoOut >= bytes;
        if (!goes)
            continue;
        share -= outgoing.isFirst ? 0 : 1;
        m_mayGoOut -= bytes;
        samples.push_back(*std::exchange(outgoing.newest, std::nullopt));
        outgoing.wentOut = now;
        --m_waiting;
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
