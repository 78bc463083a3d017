#pragma once

#include "engine/net/node/session_node.h"

#include <atomic>
#include <deque>
#include <mutex>
#include <string>
#include <thread>

namespace carina::lab
{

/// What a participant saw of another's tube in some time.
struct Seen {
    std::int64_t samples = 0;
    Duration largestGap{};   ///< between the arrivals of two samples
    double drift_mm = 0.0;   ///< root mean square of how far the shown tip was from where it was
    std::int64_t places = 0; ///< at which it was compared
};

/// An observer who watches the tube of one trainee: on a thread of its own, every half millisecond,
/// as the attack it is to withstand may keep this program's other threads busy.
///
/// The drift compares what was shown at a session time, which is extrapolated from older samples,
/// with where the samples of the owner around that time have it once they have arrived.
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
    struct Shown {
        SessionTime time;
        Vec3 p_A;
    };

    void watch();
    [[nodiscard]] std::shared_ptr<const RemoteObject> tube() const;
    void heard(const RemoteObject& object, LocalTime now);
    void compare(const RemoteObject& object, SessionTime now);

    const SessionNode& m_node;
    std::string m_owner;
    std::atomic<bool> m_sees = false;
    std::atomic<bool> m_ends = false;
    std::mutex m_mutex;
    Seen m_seen;
    double m_squares = 0.0; // of the drift, mm^2
    SessionTime m_newest{};
    LocalTime m_lastArrival{};
    SessionTime m_nextShown{};
    std::deque<Shown> m_shown; // not compared yet
    std::thread m_thread;      // last: uses what is above
};

} // namespace carina::lab
