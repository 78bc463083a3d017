#pragma once

#include "engine/net/node/session_node.h"
#include "engine/sync/strategies/application_analysis.h"

#include <map>
#include <mutex>

namespace carina
{

/// The objects that other participants share. The node's thread adds samples, any thread reads.
class RemoteObjects
{
public:
    /// Adds an object of another participant; has no effect for a known one.
    void add(ObjectId object);
    /// Removes an object that this node owns now, or that is no longer shared.
    void remove(ObjectId object);
    void clear();

    /// Adds a sample while session time `drawn` is being drawn.
    void take(const StreamCpo& cpo, SessionTime drawn);

    [[nodiscard]] std::shared_ptr<const RemoteObject> find(ObjectId object) const;
    [[nodiscard]] std::vector<ObjectReport> reports(SessionTime now) const;

private:
    mutable std::mutex m_mutex;
    std::map<ObjectId, std::shared_ptr<RemoteObject>> m_objects; // viewers draw from them too
    ApplicationAnalysis m_analysis;
};

} // namespace carina
