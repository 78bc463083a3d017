#include "engine/sync/event_cpo.h"

#include "engine/geometry/rotation.h"

#include <algorithm>
#include <cmath>

namespace carina
{

ActedPose evaluate(const EventCpo& event, SessionTime t)
{
    const double amount = double{event.rate} * toSeconds(std::max(t, event.start) - event.start);
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

} // namespace carina
