#pragma once

#include "apps/lab/attack/shown_places.h"
#include "engine/net/node/session_node.h"

#include <atomic>
#include <mutex>
#include <string>
#include <thread>

namespace carina::lab
{

/// What a participant saw of another's tube in some time.
struct Seen {
    std::int64_t samples = 0;
    Duration largestGap{}; ///< between the arrivals of two samples
    Duration latest{};     ///< between two looks of the witness itself, which the gap may hold
    ShownPlaces places{};
};

/// An observer who watches the tube of one trainee: on a thread of its own, every half millisecond,
/// as the attack it is to withstand may keep this program's other threads busy.
class Witness
{
public:
    /// @param node is in the session; outlives the witness @param owner name of the trainee
    Witness(const SessionNode& node, std::string owner);
    ~Witness();
    Witness(const Witness&) = delete;
    Witness& operator=(const Witness&) = delete;

    /// Whether the tube has been seen.
    [[nodiscard]] bool sees() const { return m_sees; }
    /// What was seen since the last call; a gap that lasts counts with its length so far.
    [[nodiscard]] Seen take();

private:
    void watch();
    [[nodiscard]] std::shared_ptr<const RemoteObject> tube() const;
    void look(const RemoteObject& object, LocalTime now, SessionTime session);

    const SessionNode& m_node;
    std::string m_owner;
    std::atomic<bool> m_sees = false;
    std::atomic<bool> m_ends = false;
    std::mutex m_mutex;
    Seen m_seen;
    SessionTime m_newest{};
    LocalTime m_lastArrival{};
    LocalTime m_lastLook{};
    std::thread m_thread; // last: uses what is above
};

} // namespace carina::lab
