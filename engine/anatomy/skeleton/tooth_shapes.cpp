#include "engine/anatomy/skeleton/tooth_shapes.h"

#include "engine/anatomy/airway/jaw_hinge.h"

#include <array>
#include <cmath>
#include <string>

namespace carina
{

namespace
{

constexpr Length kToothVoxel = millimetres(1.0);

/// A left tooth in reference millimetres (BodyPlan) from the edge of the upper incisors: the middle
/// of its edge, the tip of its root, half its width along the arch and half its depth across.
struct ToothFigures {
    const char* name;
    const char* milkName;        ///< of the tooth that stands there before school age
    double months;               ///< age at which this comes through (American Dental Association)
    std::array<int, 2> concepts; ///< left, right
    Vec3 edge;
    Vec3 root;
    double wide, deep;
};

/// No milk teeth stand where the molars of the second teeth do.
constexpr double kNever = 1e3;

const std::array kUpper{ToothFigures{"central secondary incisor",
                                     "central primary incisor",
                                     10.0,
                                     {55682, 55681},
                                     {4.5, 0, 0},
                                     {4, 9, 25},
                                     4.2,
                                     3.4},
                        ToothFigures{"lateral secondary incisor",
                                     "lateral primary incisor",
                                     11.0,
                                     {55683, 55680},
                                     {11.6, 2.5, 0},
                                     {10.5, 11, 26},
                                     3.3,
                                     3.1},
                        ToothFigures{"secondary canine",
                                     "primary canine",
                                     19.0,
                                     {55799, 55798},
                                     {17.6, 7.5, 1},
                                     {17, 13, 30},
                                     3.6,
                                     3.9},
                        ToothFigures{"first secondary premolar",
                                     "first primary molar",
                                     16.0,
                                     {55690, 55689},
                                     {20.8, 18, 2.5},
                                     {20, 18, 28.5},
                                     3.4,
                                     4.4},
                        ToothFigures{"second secondary premolar",
                                     "second primary molar",
                                     29.0,
                                     {55691, 55688},
                                     {23.6, 24.4, 3.5},
                                     {23, 24, 27.5},
                                     3.3,
                                     4.4},
                        ToothFigures{"first secondary molar",
                                     "",
                                     kNever,
                                     {55699, 55698},
                                     {24.6, 33, 5.5},
                                     {24, 33, 27.5},
                                     5.2,
                                     5.4},
                        ToothFigures{"second secondary molar",
                                     "",
                                     kNever,
                                     {55700, 55697},
                                     {24.2, 42, 9},
                                     {23.5, 42, 29},
                                     4.7,
                                     5.2}};
const std::array kLower{ToothFigures{"central secondary incisor",
                                     "central primary incisor",
                                     8.0,
                                     {57143, 57142},
                                     {3, 4, 0.5},
                                     {3, 18, -23},
                                     2.7,
                                     3.0},
                        ToothFigures{"lateral secondary incisor",
                                     "lateral primary incisor",
                                     13.0,
                                     {57141, 57140},
                                     {8.5, 5, 0.5},
                                     {8, 18, -23},
                                     2.9,
                                     3.1},
                        ToothFigures{"secondary canine",
                                     "primary canine",
                                     20.0,
                                     {55687, 55686},
                                     {14, 8.5, 1},
                                     {11.5, 20, -24},
                                     3.4,
                                     3.8},
                        ToothFigures{"first secondary premolar",
                                     "first primary molar",
                                     16.0,
                                     {55693, 55694},
                                     {18, 15, 1.5},
                                     {16.5, 25, -19},
                                     3.3,
                                     3.7},
                        ToothFigures{"second secondary premolar",
                                     "second primary molar",
                                     27.0,
                                     {55692, 55695},
                                     {20.8, 22, 2.5},
                                     {19.5, 31, -18.5},
                                     3.4,
                                     4.0},
                        ToothFigures{"first secondary molar",
                                     "",
                                     kNever,
                                     {55704, 55706},
                                     {23.2, 31, 4.5},
                                     {22.5, 37, -12},
                                     5.0,
                                     4.7},
                        ToothFigures{"second secondary molar",
                                     "",
                                     kNever,
                                     {55703, 55705},
                                     {26.6, 43, 8.5},
                                     {26, 49, -6.5},
                                     5.0,
                                     4.6}};

/// Signed distance to a left tooth, reference millimetres. The crown is a third of the length, a
/// chisel in front teeth and a cylinder in back teeth; roots are tapered.
double tooth(const ToothFigures& t, const Vec3& p)
{
    const Vec3 axis = (t.root - t.edge).normalized();
    // Along the arch: away from the midline in front, backwards at the molars.
    const Vec3 radial = Vec3{t.edge.x(), t.edge.y() - 30.0, 0.0}.normalized();
    const Vec3 out = (radial - radial.dot(axis) * axis).normalized();
    const Vec3 arch = axis.cross(out);
    const double length = (t.root - t.edge).norm();
    const Vec3 off = p - t.edge;
    const double along = off.dot(axis);
    const double down = std::clamp(along / length, 0.0, 1.0);
    // Widest at a fifth, narrower at the neck, a blunt tip.
    const double taper = down < 0.2 ? 0.9 + 0.5 * down : 1.0 - 0.8 * (down - 0.2);
    const double bevel =
        t.wide < 4.5 && t.deep < 4.0 ? 0.35 + 0.65 * std::min(down / 0.3, 1.0) : 1.0;
    const Vec2 radii{t.wide * taper, t.deep * taper * bevel};
    const double side = ellipseDistance({off.dot(arch), off.dot(out)}, radii);
    return 0.8 * roundedMax(side, std::max(-along, along - length), 1.5);
}

PartPlan planOf(const ToothFigures& t, bool upper, Side side, const BodyPlan& plan)
{
    const bool right = side == Side::Right;
    const double sign = right ? -1.0 : 1.0;
    Box bounds;
    for (const Vec3& p : {t.edge, t.root}) {
        const Vec3 here = plan.inFace({sign * p.x(), p.y(), p.z()});
        bounds.include(here - Vec3::Constant(7.0 * plan.face));
        bounds.include(here + Vec3::Constant(7.0 * plan.face));
    }
    const auto distance = [&t, sign, origin = plan.inFace(Vec3::Zero()),
                           unit = plan.face](const Vec3& p_A) {
        const Vec3 p = (p_A - origin) / unit;
        return unit * tooth(t, {sign * p.x(), p.y(), p.z()});
    };
    ImplicitShape shape{bounds, distance};
    const bool isMilk = plan.dimensions.ageInYears < kSchoolAge_years;
    return {std::string{right ? "Right " : "Left "} + (upper ? "upper " : "lower ")
                + (isMilk ? t.milkName : t.name) + " tooth",
            PartRole::Tooth, isMilk ? "" : "FMA" + std::to_string(t.concepts[right ? 1 : 0]),
            upper ? std::move(shape) : onJaw(plan, std::move(shape)),
            1e3 * plan.face * kToothVoxel};
}

} // namespace

std::vector<PartPlan> teeth(const BodyPlan& plan)
{
    const double age = plan.dimensions.ageInYears;
    const auto hasCome = [age](const ToothFigures& t) {
        return age >= kSchoolAge_years || double(std::lround(12.0 * age)) >= t.months;
    };
    std::vector<PartPlan> parts;
    for (const Side side : {Side::Left, Side::Right}) {
        for (const ToothFigures& t : kUpper)
            if (hasCome(t))
                parts.push_back(planOf(t, true, side, plan));
        for (const ToothFigures& t : kLower)
            if (hasCome(t))
                parts.push_back(planOf(t, false, side, plan));
    }
    return parts;
}

} // namespace carina
