#pragma once

#include "engine/anatomy/patient/body_plan.h"
#include "engine/anatomy/skeleton/rib_shapes.h"

namespace carina
{

/// A plane of a patient, in A.
struct AnatomyPlane {
    Vec3 p_A = Vec3::Zero();
    Vec3 normal_A = Vec3::UnitZ(); ///< unit, towards the head
};

/// Every place and plane of a patient by which depth and position are judged; exact, since the
/// surfaces are made from them.
struct PatientLandmarks {
    AirwayLandmarks airway; ///< incisors, glottis, carina, and the way of a tube between them
    RibLandmarks ribs;
    AnatomyPlane incisors; ///< through the edges of the upper teeth: it rises to the molars
    AnatomyPlane glottis;  ///< through both vocal cords, square to the windpipe
    AnatomyPlane carina;   ///< square to the windpipe
};

[[nodiscard]] PatientLandmarks landmarksOf(const BodyPlan& plan);

} // namespace carina
