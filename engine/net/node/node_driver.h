#pragma once

#include "engine/net/node/session_node.h"
#include "engine/net/secure/secure_transport.h"

namespace carina
{

/// One role's part of a node: connects a core of engine/sync with the session. Runs on the node's
/// thread; the caller passes in datagrams and time.
class NodeDriver : public TransportListener
{
public:
    using Datagrams = std::vector<SyncHost::Output::Addressed>;

    virtual void propose(StationId station, FactBody body, LocalTime now) = 0;
    virtual void publish(ObjectKind kind, std::string name, PoseSource newest) = 0;
    virtual void publishShape(ObjectKind kind, ShapeSource shape) = 0;
    virtual void act(ObjectId object, const ObjectAction& action, LocalTime now) = 0;
    /// Does what is due. To be called after every other call, and at nextWake(). @returns datagrams
    /// to send.
    [[nodiscard]] virtual Datagrams advance(LocalTime now) = 0;
    [[nodiscard]] virtual LocalTime nextWake() const = 0;
    /// Called back from any thread, from then on, when advance() is to be called at once.
    virtual void onNews(std::function<void()> callback) { static_cast<void>(callback); }
    /// Paths to close, once what the last advance() returned is sent.
    [[nodiscard]] virtual std::vector<PeerAddress> takeEnded() { return {}; }
    /// Ends the session at this node. @returns the last datagrams to send.
    [[nodiscard]] virtual Datagrams close(LocalTime now) = 0;
};

} // namespace carina
