#pragma once

#include "engine/net/node/session_node.h"
#include "engine/sync/streams/stream_tick.h"
#include "engine/sync/wire/stream_cpo.h"

namespace carina
{

/// The local objects that a node shares, asked for their poses at each tick. Lives on the node's
/// thread.
class Publications
{
public:
    struct Outgoing {
        StationId station;
        StreamCpo cpo;
    };
    struct Wanted {
        StationId station;
        fact::ObjectShared object; ///< with id 0, for the host to fill in
    };

    void add(StationId station, ObjectKind kind, std::string name, PoseSource newest);

    /// Objects that the session does not know as this participant's yet, each told of once.
    [[nodiscard]] std::vector<Wanted> takeUnknown(const SessionState& state, ParticipantId self);
    /// Another session: none of them is known there.
    void forget();

    [[nodiscard]] LocalTime nextTick() const;
    /// The samples that are new since the last tick, of objects that the session knows.
    [[nodiscard]] std::vector<Outgoing> sample(const SessionState& state, ParticipantId self,
                                               LocalTime now);

private:
    struct Publication {
        StationId station;
        ObjectKind kind;
        std::string name;
        PoseSource newest;
        bool toldOf = false;
        std::uint16_t sequence = 0;
        SessionTime lastSent = SessionTime::min();
    };
    [[nodiscard]] static std::optional<ObjectId>
    idOf(const Publication& publication, const SessionState& state, ParticipantId self);

    std::vector<Publication> m_publications;
    StreamTick m_tick;
};

} // namespace carina
