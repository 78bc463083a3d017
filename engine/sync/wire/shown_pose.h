#pragma once

#include "engine/core/ids.h"
#include "engine/core/session_time.h"
#include "engine/geometry/rigid_transform.h"

namespace carina
{

/// The pose of a shared object O that a program showed at a session time.
struct ShownPose {
    ObjectId object;
    SessionTime at{};
    RigidTransform X_AO;
};

} // namespace carina
