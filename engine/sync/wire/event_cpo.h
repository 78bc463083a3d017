#pragma once

#include "engine/core/ids.h"
#include "engine/core/session_time.h"
#include "engine/geometry/rigid_transform.h"

#include <algorithm>
#include <cstdint>

namespace carina
{

/// The largest rate of an action, in the unit of its kind.
inline constexpr double kFastestAction = 100.0;
/// How far from the origin of A an action may begin, metres: along one axis.
inline constexpr double kFarthestAction = 1e6;

enum class ActionKind : std::uint8_t { Rotation, Translation, Scaling };

/// A control packet object (CPO) of an event: an action that moves a shared object O without
/// further messages. Any node can evaluate it for any time, with bit-identical results.
///
/// With t the time since `start`: a rotation turns O about its own origin by rate t (rad) about
/// axis_A; a translation moves it by rate t (m) along axis_A; a scaling multiplies its size by
/// exp(rate t).
struct EventCpo {
    ObjectId object;
    std::uint16_t epoch = 0;  ///< of the ownership under which the action was taken
    std::uint32_t action = 0; ///< counts the owner's actions; wraps
    ActionKind kind = ActionKind::Rotation;
    SessionTime start{};
    Quat q_AO = Quat::Identity(); ///< at the start; of unit length to 1e-9
    Vec3 p_AO = Vec3::Zero();     ///< at the start, metres; at most kFarthestAction
    Vec3f axis_A = Vec3f::UnitX();
    float rate = 0.0F;  ///< rad/s, m/s or 1/s by kind; at most kFastestAction
    float scale = 1.0F; ///< size of O relative to its model at the start, above 0
};

/// Pose and size of a shared object under an action.
struct ActedPose {
    RigidTransform X_AO;
    double scale = 1.0;
};

/// A shared object as a participant draws it.
struct ShownObject {
    ActedPose acted;
    bool isStale = false; ///< no update arrived for longer than expected
    // The action in force, as in EventCpo:
    ActionKind kind = ActionKind::Rotation;
    Vec3 axis_A = Vec3::UnitX();
    double rate = 0.0;
};

/// The object at `sinceStart` after the action's start; before the start it is in the start pose.
[[nodiscard]] ActedPose evaluateAfter(const EventCpo& event, Duration sinceStart);

/// The object at session time t.
[[nodiscard]] inline ActedPose evaluate(const EventCpo& event, SessionTime t)
{
    return evaluateAfter(event, std::max(t, event.start) - event.start);
}

/// The same action, with `start` as its start time and `from` as its start pose.
[[nodiscard]] EventCpo begunFrom(const ActedPose& from, SessionTime start, EventCpo action);

} // namespace carina
