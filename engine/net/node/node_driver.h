#pragma once

#include "engine/net/node/session_node.h"
#include "engine/net/secure/secure_transport.h"

namespace carina
{

/// One role's part of a node: joins a core of engine/sync to the session behind it. Lives on the
/// node's thread; whoever runs that thread brings datagrams and time.
class NodeDriver : public TransportListener
{
public:
    using Datagrams = std::vector<SyncHost::Output::Addressed>;

    virtual void propose(StationId station, FactBody body, LocalTime now) = 0;
    virtual void publish(StationId station, ObjectKind kind, std::string name,
                         PoseSource newest) = 0;
    virtual void act(ObjectId object, const ObjectAction& action, LocalTime now) = 0;
    /// Does what is due, after everything else and at nextWake(). @returns what is to be sent.
    [[nodiscard]] virtual Datagrams advance(LocalTime now) = 0;
    [[nodiscard]] virtual LocalTime nextWake() const = 0;
    /// The last datagrams.
    [[nodiscard]] virtual Datagrams close(LocalTime now) = 0;
};

} // namespace carina
