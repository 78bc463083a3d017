#include "engine/anatomy/patient/body_plan.h"

#include "engine/anatomy/airway/airway_path.h"
#include "engine/anatomy/airway/airway_shapes.h"

#include <algorithm>
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

/// Where his glottis lies behind the edge of his incisors, reference millimetres.
constexpr double kHisGlottisBehind = 74.2;

/// The level of the glottis between the first thoracic vertebra (0) and the atlas (1): at the third
/// and fourth cervical vertebra in newborn children (0.62), from where it descends to the fifth.
double glottisLevel(double ageInYears)
{
    constexpr double kNewborn = 0.62;
    constexpr double kGrown = 0.45;
    constexpr double kYears = 5.0; // most of the descent is over by school age
    return kGrown + (kNewborn - kGrown) * std::exp(-ageInYears / kYears);
}

/// 1 in the newborn, 0 from school age on: of what the young have beyond the formulas of older
/// people.
double youthAt(double ageInYears) { return std::max(0.0, 1.0 - ageInYears / kSchoolAge_years); }

/// The height of the atlas above the carina that gives the glottis its level, metres.
double atlasHeight(const PatientDimensions& d, double chest)
{
    const Vec3 up = windpipeInAnatomy().rotation() * Vec3::UnitZ();
    const double glottis = d.cordsToCarina.si * up.z();
    const double thoracic =
        chest * (BodyPlan::kFirstThoracic_mm.z() - BodyPlan::kEdgeToCarina_mm.z());
    return thoracic + (glottis - thoracic) / glottisLevel(d.ageInYears);
}

/// How steeply the incisors lie above the glottis: by the level of the larynx until it is grown. In
/// infants no less than leaves room for a tube below the palate.
Angle riseToIncisors(const PatientDimensions& d, double chord, double chest, double face)
{
    const Vec3 up = windpipeInAnatomy().rotation() * Vec3::UnitZ();
    const double glottis = d.cordsToCarina.si * up.z();
    const double rise = atlasHeight(d, chest) - face * BodyPlan::kAtlas_mm.z() - glottis;
    // 10 degrees, in the newborn 22.
    const double flattest = 0.17 + 0.21 * youthAt(d.ageInYears);
    const double child = std::asin(std::clamp(rise / chord, flattest, 0.55));
    const double grown = std::clamp((d.ageInYears - 13.0) / 5.0, 0.0, 1.0);
    return Angle{child + grown * (kRiseToIncisors.si - child)};
}

AirwayLandmarks landmarksOf(const PatientDimensions& d, Angle rise)
{
    const Vec3 up = windpipeInAnatomy().rotation() * Vec3::UnitZ();
    AirwayLandmarks landmarks;
    landmarks.p_A_glottis = d.cordsToCarina.si * up;
    const std::array down{landmarks.p_A_glottis, landmarks.p_A_carina};
    landmarks.p_A_incisors =
        incisorsAtLength(down, metres(d.teethToCarina.si - d.cordsToCarina.si), rise);
    landmarks.path_A = airwayPath(landmarks.p_A_incisors, down);
    return landmarks;
}

} // namespace

BodyPlan bodyPlanOf(const PatientDimensions& dimensions, Posture posture)
{
    BodyPlan plan{.dimensions = dimensions,
                  .posture = posture,
                  .landmarks = landmarksOf(dimensions, kRiseToIncisors)};
    plan.airway = 1e-3 * (dimensions.cordsToCarina / kHisCordsToCarina);
    plan.chest = 1e-3 * std::cbrt(dimensions.functionalResidualCapacity / kHisLungs);
    // The geometric mean of the scale by the path over the tongue and that by height.
    const double chord = (plan.landmarks.p_A_incisors - plan.landmarks.p_A_glottis).norm();
    const double byHeight = dimensions.height / kHisHeight;
    plan.face = 1e-3 * std::sqrt(chord / kHisIncisorsToGlottis.si * byHeight);
    plan.landmarks =
        landmarksOf(dimensions, riseToIncisors(dimensions, chord, plan.chest, plan.face));
    const double behind =
        (plan.landmarks.p_A_glottis - plan.landmarks.p_A_incisors).y() / plan.face;
    plan.throat = std::max(1.0, (behind - BodyPlan::kBehindPalate_mm)
                                    / (kHisGlottisBehind - BodyPlan::kBehindPalate_mm));
    plan.infancy = std::exp(-dimensions.ageInYears / 2.0);
    plan.youth = youthAt(dimensions.ageInYears);
    const double below = plan.inFace(BodyPlan::kAtlas_mm).z() - atlasHeight(dimensions, plan.chest);
    plan.atlasBelow = std::min(2.0 * plan.youth, 1.0) * std::max(below, 0.0);
    return plan;
}

} // namespace carina
