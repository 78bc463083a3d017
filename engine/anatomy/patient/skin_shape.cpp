#include "engine/anatomy/patient/skin_shape.h"

#include "engine/anatomy/airway/jaw_hinge.h"
#include "engine/anatomy/shapes/strand.h"
#include "engine/anatomy/skeleton/cranium_shape.h"
#include "engine/anatomy/skeleton/spine_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace carina
{

namespace
{

constexpr Length kSkinVoxel = millimetres(7.0);
/// Cells are smaller around the face: half as large at its middle.
const Vec3 kMiddleOfFace{0.0, 10.0, 40.0};
constexpr double kFinestInFace = 0.5;
constexpr double kFineAround = 110.0;
/// Beyond the layer that an obese patient has everywhere.
constexpr Length kFatOfNeck = millimetres(8.0);

/// Chin and lower edge of the jaw with the mouth closed, in reference millimetres from the edge of
/// the upper incisors, of the half that p is mirrored into.
double chinDistance(const Vec3& p)
{
    const double chin = ellipsoidDistance(p - Vec3{0.0, 22.0, -30.0}, {30.0, 34.0, 26.0});
    const double edge =
        std::min(rodDistance(p, {24.0, 18.0, -26.0}, {39.0, 40.0, -21.0}, 14.0, 13.0),
                 rodDistance(p, {39.0, 40.0, -21.0}, {43.0, 70.0, -10.0}, 13.0, 13.0));
    return roundedMin(chin, edge, 14.0);
}

/// Nose with its wings.
double nose(const Vec3& p)
{
    const double ridge = rodDistance(p, {0.0, -1.0, 72.0}, {0.0, -20.0, 38.0}, 7.5, 7.5);
    const double tip = ellipsoidDistance(p - Vec3{0.0, -20.0, 33.0}, {9.5, 9.5, 8.0});
    const double wing = ellipsoidDistance(p - Vec3{11.0, -10.5, 30.0}, {7.0, 9.5, 7.0});
    return roundedMin(roundedMin(ridge, tip, 6.0), wing, 5.0);
}

/// An ear: a shell that stands off the head, with its hollow and its lobe.
double ear(const Vec3& p, double aside)
{
    // Along the shell to the back and outward, and across it.
    const Vec3 q = p - Vec3{aside, 101.0, 58.0};
    const Vec3 r{0.42 * q.x() + 0.91 * q.y(), 0.91 * q.x() - 0.42 * q.y(), q.z()};
    const double shell = ellipsoidDistance(r - Vec3{6.0, 4.0, 4.0}, {17.0, 6.5, 28.0});
    const double hollow = ellipsoidDistance(r - Vec3{3.0, 11.0, 4.0}, {9.5, 6.5, 17.0});
    const double lobe = ellipsoidDistance(r - Vec3{1.0, 4.0, -23.0}, {8.5, 5.5, 9.0});
    return roundedMin(roundedMax(shell, -hollow, 3.0), lobe, 8.0);
}

/// What lies over the bones of the face: cheeks, brow and the outer edges of the orbits, and the
/// hollows in which the lids are shut. The outer edge lies well behind the lids.
double withEyes(const Vec3& p, double face)
{
    static const std::array edge{Vec3{6, 7, 82},   Vec3{30, 10.5, 87}, Vec3{45, 22, 84},
                                 Vec3{50, 36, 74}, Vec3{51, 38, 60},   Vec3{46, 27, 42}};
    static const std::array edgeRadii{10.5, 10.0, 9.5, 9.0, 9.5, 14.0};
    static const std::array cheek{Vec3{46, 27, 42}, Vec3{60.5, 60, 50}, Vec3{56, 92, 60}};
    static const std::array cheekRadii{14.0, 11.5, 11.0};
    const double hollow = ellipsoidDistance(p - Vec3{31.0, -1.0, 66.0}, {15.5, 14.0, 9.5});
    const double aside = ellipsoidDistance(p - Vec3{57.0, -3.0, 67.0}, {17.0, 21.0, 17.0});
    const double lids = ellipsoidDistance(p - Vec3{32.0, 24.0, 65.5}, {15.0, 13.5, 12.5});
    double d = roundedMin(face, tubeDistance(p, edge, edgeRadii), 12.0);
    d = roundedMin(d, tubeDistance(p, cheek, cheekRadii), 14.0);
    d = roundedMax(roundedMax(d, -hollow, 9.0), -aside, 9.0);
    return roundedMin(d, lids, 3.0);
}

/// Head and face there, as a function of the half that p is mirrored into, with that chin.
double head(const Vec3& p, double chin, const Cranium& cranium)
{
    constexpr double kScalp = 5.5;
    const double scalp = cranium.braincase(p) - kScalp;
    const double face = ellipsoidDistance(p - Vec3{0.0, 56.0, 30.0}, {62.0, 64.0, 80.0});
    const double behindEar = rodDistance(p, {50, 102, 56}, {48, 106, 30}, 18.0, 13.0);
    const double lips = ellipsoidDistance(p - Vec3{0.0, 2.0, -4.0}, {24.0, 13.0, 14.0});
    double d = roundedMin(roundedMin(scalp, face, 24.0), behindEar, 20.0);
    d = withEyes(p, d);
    d = roundedMin(d, chin, 22.0);
    d = roundedMin(d, nose(p), 7.0);
    d = roundedMin(d, lips, 12.0);
    return roundedMin(d, ear(p, 16.0 + 55.0 * cranium.share()), 5.0);
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
    // The neck leads from before the atlas to the upper ribs.
    const Vec3 neckTop{0.0, atlasOf(plan).y() - 22.0 * plan.face, plan.inFace(Vec3::Zero()).z()};
    const Vec3 neckFoot = plan.inChest({0.0, -18.0, 40.0});
    const double girth = 0.5 * (plan.airway + plan.face) * 58.0 + 0.5 * plan.dimensions.fatLayer.si
                         + kFatOfNeck.si * plan.dimensions.fatness;
    const Vec3 face = plan.inFace(Vec3::Zero());
    const Vec3 chest = plan.inChest(Vec3::Zero());
    const Implicit chin =
        onJaw(plan, {{plan.inFace({-56.0, -12.0, -56.0}), plan.inFace({56.0, 84.0, 4.0})},
                     [face, unit = plan.face](const Vec3& p_A) {
                         return chinDistance((p_A - face) / unit);
                     }})
            .distance;
    const auto distance = [face, chest, chin, neckTop, neckFoot, girth, fat, faceUnit = plan.face,
                           chestUnit = plan.chest, cranium = Cranium{plan}](const Vec3& p_A) {
        const Vec3 p{std::abs(p_A.x()), p_A.y(), p_A.z()};
        const double neck = rodDistance(p, neckTop, neckFoot, 0.97 * girth, 1.12 * girth);
        const double above = faceUnit * head((p - face) / faceUnit, chin(p), cranium);
        const double below = chestUnit * torso((p - chest) / chestUnit, fat);
        return roundedMin(roundedMin(above, neck, 0.02), below, 0.04);
    };
    Box bounds{plan.inChest(Vec3{-205.0, -150.0 - fat, -304.0}),
               plan.inChest(Vec3{205.0, 110.0 + fat, 100.0 + fat})};
    const Box skull = Cranium{plan}.bounds();
    bounds.include(plan.inFace({-100.0, -40.0, -60.0}));
    bounds.include(plan.inFace({100.0, skull.max.y(), skull.max.z()}));
    bounds.min -= Vec3{0.04, 0.04, 0.01};
    bounds.max += Vec3::Constant(0.04);
    return {"Skin",
            PartRole::Skin,
            "FMA7163",
            {bounds, distance},
            1e3 * plan.chest * kSkinVoxel,
            FinePlace{plan.inFace(kMiddleOfFace), kFinestInFace, plan.face * kFineAround}};
}

} // namespace carina
