#include "engine/anatomy/skeleton/spine_shapes.h"

#include <algorithm>
#include <array>

namespace carina
{

namespace
{

constexpr Length kVertebraVoxel = millimetres(2.6);

/// One vertebra in reference millimetres (BodyPlan): the centre of its body, half its width, depth
/// and height, and the tips of its spinous process and of its left transverse process.
struct VertebraFigures {
    const char* name;
    int concept_;
    double y, z;
    double wide, deep, high;
    double spinousY, spinousZ;
    double transverseX, transverseY;
};

/// From above. Of the atlas, which has no body, the ring is drawn.
constexpr std::array kVertebrae{
    VertebraFigures{"Axis", 12520, 2, 170, 10, 8, 8, 45, 157, 25, 8},
    VertebraFigures{"Third cervical vertebra", 12521, 3, 150, 11, 8.5, 6.5, 40, 140, 28, 6},
    VertebraFigures{"Fourth cervical vertebra", 12522, 1, 138, 12, 8.5, 6.0, 38, 127, 27, 6},
    VertebraFigures{"Fifth cervical vertebra", 12523, -1, 123, 13, 8.5, 6.0, 42, 113, 28, 7},
    VertebraFigures{"Sixth cervical vertebra", 12524, -1, 107, 14, 9.0, 6.0, 49, 100, 29, 9},
    VertebraFigures{"Seventh cervical vertebra", 12525, 2, 91, 15, 9.0, 6.5, 57, 84, 31, 16},
    VertebraFigures{"First thoracic vertebra", 9165, 7, 73, 16, 10, 7.5, 62, 66, 35, 26},
    VertebraFigures{"Second thoracic vertebra", 9187, 12, 54, 15.5, 10.5, 8, 67, 46, 34, 32},
    VertebraFigures{"Third thoracic vertebra", 9209, 19, 34, 15, 12, 8.5, 78, 21, 31, 40},
    VertebraFigures{"Fourth thoracic vertebra", 9248, 26, 11, 15, 13.5, 9, 80, -3, 33, 46},
    VertebraFigures{"Fifth thoracic vertebra", 9922, 31, -13, 15.5, 15, 9.5, 80, -40, 34, 51},
    VertebraFigures{"Sixth thoracic vertebra", 9945, 33, -38, 16.5, 16, 10, 79, -71, 34, 55},
    VertebraFigures{"Seventh thoracic vertebra", 9968, 33, -64, 17, 17, 10, 79, -101, 35, 57},
    VertebraFigures{"Eighth thoracic vertebra", 9991, 29, -90, 17.5, 18, 10.5, 79, -127, 32, 56},
    VertebraFigures{"Ninth thoracic vertebra", 10014, 24, -116, 18, 18, 11, 74, -153, 32, 51},
    VertebraFigures{"Tenth thoracic vertebra", 10037, 18, -143, 19, 18.5, 11, 72, -180, 31, 45},
    VertebraFigures{"Eleventh thoracic vertebra", 10059, 10, -171, 19.5, 19, 11.5, 67, -203, 24,
                    38},
    VertebraFigures{"Twelfth thoracic vertebra", 10081, 2, -200, 20, 19.5, 12, 57, -224, 19, 33}};
constexpr std::size_t kFirstThoracic = 6;

/// The atlas: a ring with broad sides, in reference millimetres.
constexpr VertebraFigures kAtlas{"Atlas", 12519, 18, 187, 0, 0, 0, 39, 186, 40, 16};

/// A body: an upright drum with rounded rims and a waist.
double drum(const VertebraFigures& v, const Vec3& p)
{
    const double waist = 0.06 * (1.0 - std::min(std::abs(p.z()) / v.high, 1.0));
    const Vec2 radii = (1.0 - waist) * Vec2{v.wide, v.deep};
    return roundedMax(ellipseDistance({p.x(), p.y()}, radii), std::abs(p.z()) - v.high, 2.5);
}

/// Everything behind the body, of the half that p is mirrored into.
double arch(const VertebraFigures& v, const Vec3& p)
{
    const double up = 0.35 * v.high;
    const Vec3 pedicle{9.0, 0.75 * v.deep, up};
    const Vec3 corner{13.0, v.deep + 10.0, up};
    const Vec3 lamina{0.0, v.deep + 20.0, -1.0};
    const Vec3 transverse{v.transverseX - 4.0, v.transverseY - v.y, up};
    const Vec3 spinous{0.0, v.spinousY - v.y - 3.0, v.spinousZ - v.z + 3.0};
    const double sides = std::min(rodDistance(p, pedicle, corner, 4.0, 4.0),
                                  rodDistance(p, corner, lamina, 4.2, 4.5));
    const double processes = std::min(rodDistance(p, corner, transverse, 4.5, 4.0),
                                      rodDistance(p, lamina, spinous, 4.2, 3.0));
    return roundedMin(sides, processes, 3.0);
}

double vertebra(const VertebraFigures& v, const Vec3& p)
{
    const Vec3 q{std::abs(p.x()), p.y(), p.z()};
    return roundedMin(drum(v, p), arch(v, q), 3.0);
}

double atlas(const Vec3& p)
{
    const Vec3 q{std::abs(p.x()), p.y(), p.z()};
    const double ring = std::abs(ellipseDistance({q.x(), q.y()}, {17.0, 19.0})) - 3.5;
    const double band = roundedMax(ring, std::abs(q.z()) - 5.0, 3.0);
    const double mass = ellipsoidDistance(q - Vec3{17.0, -6.0, 0.0}, {8.0, 9.0, 9.0});
    const double wing = rodDistance(q, {20.0, -4.0, 0.0}, {37.0, -2.0, 0.0}, 5.0, 4.0);
    return roundedMin(roundedMin(band, mass, 3.0), wing, 3.0);
}

/// How far the pharynx' wall holds the middle of the neck back, reference millimetres.
constexpr double kBehindPharynx = 7.0;

/// The middle of a body in A: thoracic ones in the chest; cervical ones between the first of them
/// and the skull, which is where the face is.
Vec3 middleOf(const VertebraFigures& v, bool cervical, const BodyPlan& plan)
{
    const Vec3 here{0.0, v.y, v.z};
    if (!cervical)
        return plan.inChest(here);
    const VertebraFigures& first = kVertebrae[kFirstThoracic];
    const Vec3 base{0.0, first.y, first.z};
    const Vec3 top{0.0, kAtlas.y, kAtlas.z};
    const double up = (v.z - first.z) / (kAtlas.z - first.z);
    const Vec3 bow =
        here - base - up * (top - base) + 4.0 * up * (1.0 - up) * kBehindPharynx * Vec3::UnitY();
    return (1.0 - up) * plan.inChest(base) + up * atlasOf(plan) + plan.airway * bow;
}

Box boundsOf(const VertebraFigures& v)
{
    Box box;
    box.include(Vec3{-v.transverseX - 8.0, -v.deep - 4.0 - 20.0 * (v.deep == 0.0), -v.high - 10.0});
    box.include(Vec3{v.transverseX + 8.0, v.spinousY - v.y + 6.0, v.high + 10.0});
    box.include(Vec3{0.0, 0.0, v.spinousZ - v.z - 6.0});
    return box;
}

template <class Distance>
PartPlan planOf(const VertebraFigures& v, const Vec3& middle_A, double unit, Distance local)
{
    Box bounds = boundsOf(v);
    bounds = {middle_A + unit * bounds.min, middle_A + unit * bounds.max};
    const auto distance = [middle_A, unit, local](const Vec3& p_A) {
        return unit * local((p_A - middle_A) / unit);
    };
    return {v.name,
            PartRole::Spine,
            "FMA" + std::to_string(v.concept_),
            {bounds, distance},
            1e3 * unit * kVertebraVoxel};
}

} // namespace

/// A child's throat is drawn out between palate and glottis, which its neck is not: so the way back
/// from the glottis counts, of which the pharynx has one share and half the atlas the other.
Vec3 atlasOf(const BodyPlan& plan)
{
    constexpr double kThroughPharynx = 17.1; // reference millimetres of the face
    constexpr double kHalfAtlas = 22.5;      // and of the neck
    return {0.0,
            plan.landmarks.p_A_glottis.y() + kThroughPharynx * plan.face + kHalfAtlas * plan.airway,
            plan.inFace(BodyPlan::kAtlas_mm).z() - plan.atlasBelow};
}

std::vector<PartPlan> spine(const BodyPlan& plan)
{
    std::vector<PartPlan> parts;
    parts.push_back(planOf(kAtlas, middleOf(kAtlas, true, plan), plan.airway, atlas));
    for (std::size_t i = 0; i < kVertebrae.size(); ++i) {
        const VertebraFigures& v = kVertebrae[i];
        const bool cervical = i < kFirstThoracic;
        parts.push_back(planOf(v, middleOf(v, cervical, plan), cervical ? plan.airway : plan.chest,
                               [&v](const Vec3& p) { return vertebra(v, p); }));
    }
    return parts;
}

} // namespace carina
