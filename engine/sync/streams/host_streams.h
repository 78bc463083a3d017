#pragma once

#include "engine/sync/streams/stream_table.h"
#include "engine/sync/streams/stream_tick.h"
#include "engine/sync/wire/datagram.h"

#include <map>
#include <vector>

namespace carina
{

/// The session host's end of streams: accepts samples from each object's owner (the host included),
/// and forwards the newest of each object to everybody else at each tick.
class HostStreams
{
public:
    void share(ObjectId object, ParticipantId owner) { m_table.share(object, owner); }
    /// @returns whether the sample is accepted (StreamTable::accept), and thus forwarded.
    bool take(const StreamSample& sample, SessionTime session);

    [[nodiscard]] bool isDue(LocalTime now) const;
    [[nodiscard]] LocalTime nextDue() const;
    /// Records to send to a participant at this tick.
    [[nodiscard]] std::vector<WireRecord> dueTo(ParticipantId participant) const;
    /// Ends the tick: all participants were sent their records.
    void served(LocalTime now);

private:
    StreamTable m_table;
    StreamTick m_tick;
    std::map<ObjectId, StreamSample> m_outgoing; // the newest of each
};

} // namespace carina
