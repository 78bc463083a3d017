#pragma once

#include "engine/core/session_time.h"
#include "engine/geometry/rigid_transform.h"

#include <mutex>

namespace carina
{

/// A scripted hand that holds a stylus: the true pose X_TS for a station without a person. Each
/// command (park, hold, swing) moves the stylus smoothly from its current pose to the new one
/// within kReach.
///
/// While it holds a point, the tip stays on it and the stylus sways by 3 degrees about it, as in a
/// person's hand. While it swings, the tip stays in a divot and the z axis of the stylus is tilted
/// by 15 to 30 degrees in a direction that rotates once in two seconds.
///
/// Commands come from one thread; at() may be called from any.
class StylusHand
{
public:
    /// Duration of the movement after a command.
    static constexpr Duration kReach = std::chrono::milliseconds{800};

    /// @param X_TS_parked pose of the parked stylus
    /// @param p_SQ the true tip in the stylus frame S, metres
    StylusHand(const RigidTransform& X_TS_parked, const Vec3& p_SQ);

    /// Moves the stylus to its parked pose.
    void park(SessionTime now);
    /// Holds the tip at a point Q, metres.
    void hold(const Vec3& p_TQ, SessionTime now);
    /// Swings the stylus with its tip in a divot Q, metres.
    void swing(const Vec3& p_TQ, SessionTime now);

    /// X_TS at time t; for a time before the latest command, the pose at which that began.
    [[nodiscard]] RigidTransform at(SessionTime t) const;

private:
    enum class Task : std::uint8_t { Park, Hold, Swing };

    void begin(Task task, const Vec3& p_TQ, SessionTime now);
    [[nodiscard]] RigidTransform goal(SessionTime t) const;
    [[nodiscard]] RigidTransform poseAt(SessionTime t) const;

    RigidTransform m_X_TS_parked;
    Vec3 m_p_SQ;
    mutable std::mutex m_mutex;
    Task m_task = Task::Park;
    Vec3 m_p_TQ = Vec3::Zero();
    RigidTransform m_X_TS_start; ///< at the latest command
    SessionTime m_since{};
};

} // namespace carina
