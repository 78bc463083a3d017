#pragma once

#include "engine/net/node/session_node.h"
#include "engine/sync/strategies/application_analysis.h"

#include <map>
#include <mutex>

namespace carina
{

/// The objects that others share, as their samples arrive. The node's thread adds, any thread asks.
class RemoteObjects
{
public:
    /// An object of another participant; nothing changes for one that is known.
    void add(ObjectId object);
    /// It is this node's own now, or gone.
    void remove(ObjectId object);
    void clear();

    /// Takes a sample in while session time `drawn` is drawn, and measures how far it moves that.
    void take(const StreamCpo& cpo, SessionTime drawn);

    [[nodiscard]] std::shared_ptr<const RemoteObject> find(ObjectId object) const;
    [[nodiscard]] std::vector<ObjectReport> reports(SessionTime now) const;

private:
    struct Object {
        std::shared_ptr<RemoteObject> poses; // also held by the viewers that draw from it
        Drift drift{};
    };

    mutable std::mutex m_mutex;
    std::map<ObjectId, Object> m_objects;
    ApplicationAnalysis m_analysis;
};

} // namespace carina
