#pragma once

#include "engine/core/ids.h"
#include "engine/core/session_time.h"
#include "engine/geometry/rigid_transform.h"

namespace carina
{

/// The pose and the size of a shared object O that a program showed at a session time.
struct ShownPose {
    ObjectId object;
    SessionTime at{};
    RigidTransform X_AO;
    double scale = 1.0; ///< size of O relative to its model, above 0; a float on the wire
};

} // namespace carina
