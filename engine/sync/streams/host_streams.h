#pragma once

#include "engine/sync/streams/stream_table.h"
#include "engine/sync/streams/stream_tick.h"
#include "engine/sync/wire/datagram.h"

#include <map>
#include <vector>

namespace carina
{

/// The session host's part in streams: takes the samples of each object's owner, its own included,
/// and with each tick passes the newest of each object on to everybody else.
class HostStreams
{
public:
    void share(ObjectId object, ParticipantId owner) { m_table.share(object, owner); }
    /// @returns whether it is to be passed on and used: see StreamTable::accept.
    bool take(const StreamSample& sample, SessionTime session);

    [[nodiscard]] bool isDue(LocalTime now) const;
    [[nodiscard]] LocalTime nextDue() const;
    /// What a participant is sent with this tick.
    [[nodiscard]] std::vector<WireRecord> dueTo(ParticipantId participant) const;
    /// Everybody was sent what was due.
    void served(LocalTime now);

private:
    StreamTable m_table;
    StreamTick m_tick;
    std::map<ObjectId, StreamSample> m_outgoing; // the newest of each
};

} // namespace carina
