#include "engine/anatomy/patient/body_plan.h"

#include "engine/anatomy/airway/airway_path.h"
#include "engine/anatomy/airway/airway_shapes.h"

#include <array>
#include <cmath>

namespace carina
{

namespace
{

/// The reference man of BodyPlan: cords to carina along the trachea, height, volume of the lungs,
/// incisors to glottis in a straight line.
constexpr Length kHisCordsToCarina = millimetres(121.9);
constexpr Length kHisHeight = metres(1.729);
constexpr Volume kHisLungs = litres(2.864);
constexpr Length kHisIncisorsToGlottis = millimetres(87.6);

AirwayLandmarks landmarksOf(const PatientDimensions& d)
{
    const Vec3 up = windpipeInAnatomy().rotation() * Vec3::UnitZ();
    AirwayLandmarks landmarks;
    landmarks.p_A_glottis = d.cordsToCarina.si * up;
    const std::array down{landmarks.p_A_glottis, landmarks.p_A_carina};
    landmarks.p_A_incisors =
        incisorsAtLength(down, metres(d.teethToCarina.si - d.cordsToCarina.si));
    landmarks.path_A = airwayPath(landmarks.p_A_incisors, down);
    return landmarks;
}

} // namespace

BodyPlan bodyPlanOf(const PatientDimensions& dimensions, Posture posture)
{
    BodyPlan plan{
        .dimensions = dimensions, .posture = posture, .landmarks = landmarksOf(dimensions)};
    plan.airway = 1e-3 * (dimensions.cordsToCarina / kHisCordsToCarina);
    plan.chest = 1e-3 * std::cbrt(dimensions.functionalResidualCapacity / kHisLungs);
    // The geometric mean of the scale by the path over the tongue and that by height.
    const double byWay = (plan.landmarks.p_A_incisors - plan.landmarks.p_A_glottis).norm()
                         / kHisIncisorsToGlottis.si;
    const double byHeight = dimensions.height / kHisHeight;
    plan.face = 1e-3 * std::sqrt(byWay * byHeight);
    return plan;
}

} // namespace carina
