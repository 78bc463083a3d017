#pragma once

#include "engine/net/node/session_node.h"
#include "engine/sync/streams/stream_tick.h"
#include "engine/sync/wire/stream_cpo.h"
#include "engine/tracking/pose_history.h"

#include <map>
#include <memory>

namespace carina
{

/// The local objects that a node shares; samples them at each tick. Used on the node's thread.
class Publications
{
public:
    struct Outgoing {
        StationId station;
        StreamCpo cpo;
    };
    /// An object to be proposed to the host.
    struct Wanted {
        StationId station;         ///< where the participant is
        fact::ObjectShared object; ///< with id 0; the host assigns it
    };

    void add(ObjectKind kind, std::string name, PoseSource newest);
    /// As SessionNode::publishShape.
    void bend(ObjectKind kind, ShapeSource shape);

    /// Objects that the session does not list as this participant's yet; each is returned once.
    [[nodiscard]] std::vector<Wanted> takeUnknown(const SessionState& state, ParticipantId self);
    /// Resets for another session: no object is known there.
    void forget();

    /// X_A<object> as it was measured at session time t; nothing where it was not.
    [[nodiscard]] std::optional<RigidTransform> measured(ObjectId object, const SessionState& state,
                                                         ParticipantId self, SessionTime t) const;

    [[nodiscard]] LocalTime nextTick() const;
    /// At a tick, the samples newer than the last sent, of objects that the session lists.
    [[nodiscard]] std::vector<Outgoing> sample(const SessionState& state, ParticipantId self,
                                               LocalTime now);

private:
    struct Publication {
        ObjectKind kind;
        std::string name;
        PoseSource newest;
        bool toldOf = false;
        std::uint16_t sequence = 0;
        SessionTime lastSent = SessionTime::min();
        StationId sentAt = kNoStation; ///< the station of what follows
        std::unique_ptr<PoseHistory> sent = std::make_unique<PoseHistory>();
    };
    [[nodiscard]] static std::optional<ObjectId>
    idOf(const Publication& publication, const SessionState& state, ParticipantId self);

    [[nodiscard]] std::optional<StreamShape> shapeOf(ObjectKind kind, SessionTime ofSample) const;

    std::vector<Publication> m_publications;
    std::map<ObjectKind, ShapeSource> m_shapes;
    StreamTick m_tick;
};

} // namespace carina
