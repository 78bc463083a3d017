#pragma once

#include "engine/net/node/session_node.h"
#include "engine/sync/strategies/application_analysis.h"
#include "engine/sync/streams/stream_table.h"

#include <map>
#include <mutex>

namespace carina
{

/// The objects that other participants share who are present: the history of what somebody owns who
/// has gone is given up. The node's thread adds samples, any thread reads.
class RemoteObjects
{
public:
    /// An object of which no sample has come for this long keeps the newest alone, so that who
    /// streams one object after the other fills no memory.
    static constexpr Duration kPastKept = std::chrono::seconds{10};
    /// How often it is looked which these are.
    static constexpr Duration kLook = std::chrono::seconds{1};

    /// Adds an object of another participant; of a known one it sets the owner. Poses at another
    /// station are not continued: they are in the frame of another patient.
    void add(ObjectId object, ParticipantId owner, StationId station);
    /// Removes an object that this node owns now, or nobody who is present.
    void remove(ObjectId object);
    void clear();

    /// Adds a sample while session time `drawn` is being drawn; one of a station where the object
    /// is not is dropped.
    void take(const StreamSample& sample, SessionTime drawn);
    /// Counts a sample of an object of this node, which goes out.
    void sent(ParticipantId self, const StreamCpo& cpo);

    [[nodiscard]] std::shared_ptr<const RemoteObject> find(ObjectId object) const;
    /// How often each participant's samples arrive, and those of this node go out.
    [[nodiscard]] ApplicationAnalysis analysis() const;
    [[nodiscard]] std::vector<ObjectReport> reports(SessionTime now) const;

private:
    struct Object {
        std::shared_ptr<RemoteObject> poses; // also held by the viewers that draw from it
        ParticipantId owner = kNobody;
        StationId station = kNoStation;
    };

    /// With the mutex locked.
    void forgetPasts(SessionTime drawn);

    mutable std::mutex m_mutex;
    std::map<ObjectId, Object> m_objects;
    SessionTime m_nextLook = SessionTime::min();
    ApplicationAnalysis m_analysis;
};

} // namespace carina
