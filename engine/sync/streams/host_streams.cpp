#include "engine/sync/streams/host_streams.h"

namespace carina
{

bool HostStreams::take(const StreamSample& sample, SessionTime session)
{
    if (!m_table.accept(sample, session))
        return false;
    m_outgoing.insert_or_assign(sample.cpo.object, sample);
    return true;
}

bool HostStreams::isDue(LocalTime now) const { return !m_outgoing.empty() && m_tick.isDue(now); }

LocalTime HostStreams::nextDue() const
{
    return m_outgoing.empty() ? LocalTime::max() : m_tick.next();
}

std::vector<WireRecord> HostStreams::dueTo(ParticipantId participant) const
{
    std::vector<StreamSample> samples;
    for (const auto& [object, sample] : m_outgoing)
        if (sample.owner != participant)
            samples.push_back(sample);
    std::vector<WireRecord> records;
    for (StreamGroup& group : groupStreams(samples))
        records.emplace_back(std::move(group));
    return records;
}

void HostStreams::served(LocalTime now)
{
    m_outgoing.clear();
    m_tick.served(now);
}

} // namespace carina
