#include "engine/anatomy/patient/skin_shape.h"

#include "engine/anatomy/airway/jaw_hinge.h"

#include <cmath>

namespace carina
{

namespace
{

constexpr Length kSkinVoxel = millimetres(7.0);
/// Beyond the layer that an obese patient has everywhere.
constexpr Length kFatOfNeck = millimetres(8.0);

/// The chin with the mouth closed, in reference millimetres from the edge of the upper incisors.
double chinDistance(const Vec3& p)
{
    return ellipsoidDistance(p - Vec3{0.0, 22.0, -30.0}, {30.0, 34.0, 26.0});
}

/// Head and face there, as a function of the half that p is mirrored into, with that chin and that
/// size of the cranium to the face. An infant's does not overhang the face.
double head(const Vec3& p, double chin, double cranium, double youth)
{
    const Vec3 middle{0.0, 103.0 + 25.0 * youth, 7.0 + 93.0 * cranium};
    const double skull = ellipsoidDistance(p - middle, cranium * Vec3{81.0, 100.0, 93.0});
    const double face = ellipsoidDistance(p - Vec3{0.0, 52.0, 32.0}, {62.0, 66.0, 78.0});
    const double nose = rodDistance(p, {0.0, -4.0, 58.0}, {0.0, -20.0, 30.0}, 8.0, 11.0);
    const double lips = ellipsoidDistance(p - Vec3{0.0, 2.0, -4.0}, {24.0, 13.0, 14.0});
    const double ear = ellipsoidDistance(p - Vec3{78.0, 98.0, 56.0}, {10.0, 18.0, 32.0});
    double d = roundedMin(skull, face, 30.0);
    d = roundedMin(d, chin, 26.0);
    d = roundedMin(d, nose, 10.0);
    d = roundedMin(d, lips, 14.0);
    return roundedMin(d, ear, 8.0);
}

/// The cranium is near its final size long before the face is: a newborn child's is half again as
/// large as its face would have it. Round the head are 34.5, 46.1, 48.3 and 50.3 cm in boys at
/// birth and at one, two and four years (medians of WHO's growth standards), 57 cm in the man.
double cranialShare(const BodyPlan& plan)
{
    return 1.0 + 0.13 * std::exp(-plan.dimensions.ageInYears / 5.0) + 0.40 * plan.youth;
}

/// The torso, in reference millimetres from the lowest edge of the trachea; `fat` under the skin.
double torso(const Vec3& p, double fat)
{
    // Sections with rounded corners that are widest at the lower ribs and narrow to the shoulders.
    const double up = easedStep(-200.0, 70.0, p.z());
    const double wide = 141.0 - 36.0 * up;
    const double front = 134.0 - 62.0 * up;
    const double back = 90.0 - 12.0 * up;
    const double middle = 0.5 * (back - front);
    const double deep = 0.5 * (back + front);
    const double x = std::abs(p.x()) / wide;
    const double y = std::abs(p.y() - middle) / deep;
    const double e = std::pow(std::pow(x, 2.6) + std::pow(y, 2.6), 1.0 / 2.6);
    const double sides = 0.7 * (e - 1.0) * deep - fat;
    const double chest = roundedMax(sides, p.z() - 62.0 - 0.4 * fat, 70.0);
    const double shoulder =
        rodDistance(p, {30.0, 8.0, 52.0}, {150.0, 14.0, 40.0}, 34.0 + 0.5 * fat, 38.0 + 0.5 * fat);
    const double belly = roundedMax(chest, -298.0 - p.z(), 16.0);
    return roundedMin(belly, shoulder, 60.0);
}

} // namespace

PartPlan skin(const BodyPlan& plan)
{
    const double fat = plan.dimensions.fatLayer.si / plan.chest;
    // The neck leads from the middle of the head to the upper ribs.
    const Vec3 neckTop = plan.inFace({0.0, 92.0, 0.0});
    const Vec3 neckFoot = plan.inChest({0.0, -18.0, 40.0});
    const double girth = 0.5 * (plan.airway + plan.face) * 58.0 + 0.5 * plan.dimensions.fatLayer.si
                         + kFatOfNeck.si * plan.dimensions.fatness;
    const Vec3 face = plan.inFace(Vec3::Zero());
    const Vec3 chest = plan.inChest(Vec3::Zero());
    const Implicit chin =
        onJaw(plan, {{plan.inFace({-30.0, -12.0, -56.0}), plan.inFace({30.0, 56.0, -4.0})},
                     [face, unit = plan.face](const Vec3& p_A) {
                         return chinDistance((p_A - face) / unit);
                     }})
            .distance;
    const auto distance = [face, chest, chin, neckTop, neckFoot, girth, fat, faceUnit = plan.face,
                           chestUnit = plan.chest, cranium = cranialShare(plan),
                           youth = plan.youth](const Vec3& p_A) {
        const Vec3 p{std::abs(p_A.x()), p_A.y(), p_A.z()};
        const double neck = rodDistance(p, neckTop, neckFoot, 0.97 * girth, 1.12 * girth);
        const double above = faceUnit * head((p - face) / faceUnit, chin(p), cranium, youth);
        const double below = chestUnit * torso((p - chest) / chestUnit, fat);
        return roundedMin(roundedMin(above, neck, 0.02), below, 0.04);
    };
    Box bounds{plan.inChest(Vec3{-205.0, -150.0 - fat, -304.0}),
               plan.inChest(Vec3{205.0, 110.0 + fat, 100.0 + fat})};
    bounds.include(plan.inFace({-95.0, -40.0, 0.0}));
    bounds.include(plan.inFace({95.0, 210.0, 200.0}));
    bounds.min -= Vec3{0.04, 0.04, 0.01};
    bounds.max += Vec3::Constant(0.04);
    return {"Skin", PartRole::Skin, "FMA7163", {bounds, distance}, 1e3 * plan.chest * kSkinVoxel};
}

} // namespace carina
