#include "engine/sync/wire/event_cpo.h"

#include "engine/geometry/rotation.h"

#include <cmath>

namespace carina
{

ActedPose evaluateAfter(const EventCpo& event, Duration sinceStart)
{
    const double amount = double{event.rate} * toSeconds(std::max(sinceStart, Duration{}));
    const Vec3 axis_A = event.axis_A.cast<double>();
    ActedPose acted{RigidTransform{event.q_AO, event.p_AO}, double{event.scale}};
    switch (event.kind) {
    case ActionKind::Rotation:
        acted.X_AO = RigidTransform{rotationFromVector(amount * axis_A) * event.q_AO, event.p_AO};
        break;
    case ActionKind::Translation:
        acted.X_AO = RigidTransform{event.q_AO, event.p_AO + amount * axis_A};
        break;
    case ActionKind::Scaling:
        acted.scale *= std::exp(amount);
        break;
    }
    return acted;
}

EventCpo begunFrom(const ActedPose& from, SessionTime start, EventCpo action)
{
    action.start = start;
    action.q_AO = from.X_AO.rotation();
    action.p_AO = from.X_AO.translation();
    action.scale = static_cast<float>(from.scale);
    return action;
}

} // namespace carina
