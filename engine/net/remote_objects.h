#pragma once

#include "engine/net/session_node.h"
#include "engine/sync/drift.h"
#include "engine/sync/stream_cpo.h"

#include <map>
#include <mutex>

namespace carina
{

/// The objects that others share, as their samples arrive. The node's thread adds, any thread asks.
class RemoteObjects
{
public:
    /// A pose without news for so long is stale.
    static constexpr Duration kStaleAfter = std::chrono::milliseconds{300};

    /// An object of another participant; nothing changes for one that is known.
    void add(ObjectId object);
    /// It is this node's own now, or gone.
    void remove(ObjectId object);
    void clear();

    /// Takes a sample in, and measures how far it lies from what was shown for its time.
    void take(const StreamCpo& cpo);

    [[nodiscard]] std::shared_ptr<const PoseHistory> history(ObjectId object) const;
    [[nodiscard]] std::vector<ObjectReport> reports(SessionTime now) const;

private:
    struct Object {
        std::shared_ptr<PoseHistory> history; // also held by the viewers that draw from it
        Drift drift{};
    };

    mutable std::mutex m_mutex;
    std::map<ObjectId, Object> m_objects;
};

} // namespace carina
