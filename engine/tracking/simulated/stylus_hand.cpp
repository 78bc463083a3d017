#include "engine/tracking/simulated/stylus_hand.h"

#include "engine/core/units.h"
#include "engine/geometry/rotation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace carina
{
namespace
{

constexpr double kSwingsPerSecond = 0.5;
constexpr double kTiltsPerSecond = 0.7;
constexpr double kWidensPerSecond = 0.11; ///< the swing, from half its width to all of it
constexpr Angle kSwingWidth = degrees(30.0);
constexpr Angle kTilt = degrees(3.0);

/// A turn about an axis across z that goes round: what tilts z to all sides in turn.
Quat tiltedRound(Angle tilt, double turns)
{
    const double round = 2.0 * std::numbers::pi * turns;
    return rotationFromVector(tilt.si * Vec3{std::cos(round), std::sin(round), 0.0});
}

} // namespace

StylusHand::StylusHand(const RigidTransform& X_TS_parked, const Vec3& p_SQ)
    : m_X_TS_parked{X_TS_parked}, m_p_SQ{p_SQ}, m_X_TS_start{X_TS_parked}
{
}

void StylusHand::park(SessionTime now) { begin(Task::Park, Vec3::Zero(), now); }

void StylusHand::hold(const Vec3& p_TQ, SessionTime now) { begin(Task::Hold, p_TQ, now); }

void StylusHand::swing(const Vec3& p_TQ, SessionTime now) { begin(Task::Swing, p_TQ, now); }

RigidTransform StylusHand::at(SessionTime t) const
{
    const std::scoped_lock lock{m_mutex};
    return poseAt(t);
}

void StylusHand::begin(Task task, const Vec3& p_TQ, SessionTime now)
{
    const std::scoped_lock lock{m_mutex};
    m_X_TS_start = poseAt(now);
    m_task = task;
    m_p_TQ = p_TQ;
    m_since = now;
}

RigidTransform StylusHand::goal(SessionTime t) const
{
    if (m_task == Task::Park)
        return m_X_TS_parked;
    const double seconds = toSeconds(t.time_since_epoch());
    const double wide = 0.75 + 0.25 * std::sin(2.0 * std::numbers::pi * kWidensPerSecond * seconds);
    const Quat tilt = m_task == Task::Swing
                          ? tiltedRound(kSwingWidth * wide, kSwingsPerSecond * seconds)
                          : tiltedRound(kTilt, kTiltsPerSecond * seconds);
    const Quat q_TS = m_X_TS_parked.rotation() * tilt;
    return {q_TS, m_p_TQ - q_TS * m_p_SQ};
}

RigidTransform StylusHand::poseAt(SessionTime t) const
{
    const double reached = std::clamp(toSeconds(t - m_since) / toSeconds(kReach), 0.0, 1.0);
    if (reached == 1.0)
        return goal(t);
    return interpolate(m_X_TS_start, goal(t), reached * reached * (3.0 - 2.0 * reached));
}

} // namespace carina
