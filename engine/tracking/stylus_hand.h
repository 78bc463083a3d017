#pragma once

#include "engine/core/session_time.h"
#include "engine/geometry/rigid_transform.h"

#include <mutex>

namespace carina
{

/// A scripted hand that holds a stylus: the true pose X_TS for a station without a person. It is
/// told what to do next and moves there from where it is, gently, in kReach.
///
/// A hand that holds a point keeps the tip on it and sways the stylus by 3 degrees about it, as
/// people do. A hand that swings keeps the tip in a divot and tilts the stylus's z axis to all
/// sides, by 15 to 30 degrees, once round in two seconds.
///
/// Told on one thread, asked on any.
class StylusHand
{
public:
    /// From one place to the next.
    static constexpr Duration kReach = std::chrono::milliseconds{800};

    /// @param X_TS_parked where the stylus rests
    /// @param p_SQ the true tip in the stylus frame S, metres
    StylusHand(const RigidTransform& X_TS_parked, const Vec3& p_SQ);

    void park(SessionTime now);
    /// Holds the tip at a point.
    void hold(const Vec3& p_TQ, SessionTime now);
    /// Swings the stylus with its tip in a divot.
    void swing(const Vec3& p_TQ, SessionTime now);

    /// X_TS at a time; for times before the latest order, as if it had just been given.
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
    RigidTransform m_X_TS_start; ///< where it was when it was told
    SessionTime m_since{};
};

} // namespace carina
