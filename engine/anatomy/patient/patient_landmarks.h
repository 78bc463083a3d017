#pragma once

#include "engine/anatomy/patient/body_plan.h"
#include "engine/anatomy/skeleton/rib_shapes.h"

namespace carina
{

/// A plane of a patient, in A, metres.
struct AnatomyPlane {
    Vec3 p_A = Vec3::Zero();
    Vec3 normal_A = Vec3::UnitZ(); ///< unit, towards the head
};

/// The points and planes of a patient by which depth and position are measured. They are exact, as
/// the surfaces are made from them.
struct PatientLandmarks {
    AirwayLandmarks airway; ///< incisors, glottis, carina, and the path of a tube
    RibLandmarks ribs;
    AnatomyPlane incisors; ///< through the edges of the upper teeth; rises towards the molars
    AnatomyPlane glottis;  ///< through both vocal cords, perpendicular to the trachea
    AnatomyPlane carina;   ///< perpendicular to the trachea
};

/// The landmarks of a patient that is made by this plan.
[[nodiscard]] PatientLandmarks landmarksOf(const BodyPlan& plan);

} // namespace carina
