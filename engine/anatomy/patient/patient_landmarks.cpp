#include "engine/anatomy/patient/patient_landmarks.h"

#include "engine/anatomy/airway/airway_shapes.h"

#include <cmath>

namespace carina
{

PatientLandmarks landmarksOf(const BodyPlan& plan)
{
    // The edge of the second molar lies 9 mm higher and 42 mm further back than the incisors'.
    const double rise = std::atan2(9.0, 42.0);
    const Vec3 up = windpipeInAnatomy().rotation() * Vec3::UnitZ();
    return {.airway = plan.landmarks,
            .ribs = ribLandmarksOf(plan),
            .incisors = {plan.landmarks.p_A_incisors, {0.0, -std::sin(rise), std::cos(rise)}},
            .glottis = {plan.landmarks.p_A_glottis, up},
            .carina = {plan.landmarks.p_A_carina, up}};
}

} // namespace carina
