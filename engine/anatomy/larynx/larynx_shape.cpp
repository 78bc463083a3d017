#include "engine/anatomy/larynx/larynx_shape.h"

#include "engine/anatomy/larynx/hyoid_shape.h"
#include "engine/anatomy/larynx/laryngeal_mucosa.h"
#include "engine/anatomy/larynx/larynx_frame.h"
#include "engine/anatomy/larynx/vallecula_shape.h"

#include <array>
#include <cmath>
#include <utility>

namespace carina
{

namespace
{

/// Shapes are written in the millimetres of LarynxFrame.

/// A lamina of the thyroid cartilage seen from above, from the prominence to its back edge.
std::vector<Vec2> laminaPlan()
{
    return cornersCut({Vec2{0.0, -17.0}, Vec2{2.5, -16.2}, Vec2{8.0, -9.0}, Vec2{14.0, 0.0},
                       Vec2{18.0, 9.0}, Vec2{19.5, 15.0}},
                      2);
}

/// The same lamina rolled out: along the plan, and up. Notch in front, two horns at the back.
std::array<Vec2, 15> laminaOutline()
{
    return {Vec2{-5.0, 7.0},   Vec2{0.0, 7.0},    Vec2{6.0, 15.0},   Vec2{18.0, 17.0},
            Vec2{31.5, 13.0},  Vec2{33.0, 26.0},  Vec2{36.5, 26.0},  Vec2{38.0, 12.0},
            Vec2{37.0, -10.0}, Vec2{37.0, -21.0}, Vec2{33.5, -21.0}, Vec2{32.0, -9.0},
            Vec2{14.0, -12.0}, Vec2{0.0, -9.0},   Vec2{-5.0, -9.0}};
}

double thyroid(const Vec3& p)
{
    static const auto plan = laminaPlan();
    static const auto outline = laminaOutline();
    const AlongLine at = alongLine({std::abs(p.x()), p.y()}, plan);
    return roundedMax(at.off - 1.5, polygonDistance({at.along, p.z()}, outline), 2.0);
}

/// A signet ring: a low arch in front, a high plate at the back. `radii` of the trachea below.
double cricoid(const Vec3& p, const Vec2& radii)
{
    const Vec2 wall = radii + Vec2::Constant(1.2);
    const double ring = std::abs(ellipseDistance({p.x(), p.y()}, wall)) - 2.2;
    const double backward = easedStep(-0.2 * wall.y(), 0.9 * wall.y(), p.y());
    const double top = kTracheaTop_mm + 7.0 + 14.0 * backward;
    const double slab = std::max(kTracheaTop_mm - p.z(), p.z() - top);
    return roundedMax(ring, slab, 2.0);
}

/// Of the half that p is mirrored into: towards the cord's own side.
double cord(const Vec3& p) { return rodDistance(p, {1.2, -13.5, 0.0}, {8.0, 8.5, 0.0}, 1.3, 1.7); }

double arytenoid(const Vec3& p)
{
    return rodDistance(p, {8.6, 10.6, -5.0}, {5.0, 12.5, 8.0}, 3.4, 1.6);
}

constexpr Length kLarynxVoxel = millimetres(1.1);
constexpr Length kEpiglottisVoxel = millimetres(0.6); ///< for a rim that is thin and smooth

PartPlan planOf(const char* name, PartRole role, const char* concept_, const LarynxFrame& frame,
                const Box& box, Implicit local, Length voxel = kLarynxVoxel)
{
    return {name, role, concept_, frame.inAnatomy(box, std::move(local)),
            1e3 * frame.unit() * voxel};
}

PartPlan onSide(const char* name, const char* concept_, const LarynxFrame& frame, double sign,
                double (*half)(const Vec3&))
{
    const Box box{Vec3{sign > 0.0 ? 0.0 : -15.0, -17.0, -10.0},
                  Vec3{sign > 0.0 ? 15.0 : 0.0, 18.0, 12.0}};
    return planOf(name, PartRole::Larynx, concept_, frame, box, [sign, half](const Vec3& p) {
        return half({sign * p.x(), p.y(), p.z()});
    });
}

} // namespace

std::vector<PartPlan> larynx(const BodyPlan& plan)
{
    const PatientDimensions& d = plan.dimensions;
    const LarynxFrame frame{d};
    const Epiglottis leaf{plan};
    const UpperTrachea& upper = d.upperTrachea;
    const Vec2 radii = 0.5 * Vec2{upper.coronal.si, upper.sagittal.si} / frame.unit();
    std::vector<PartPlan> parts{
        planOf("Thyroid cartilage", PartRole::Larynx, "FMA55099", frame,
               {Vec3{-24, -21, -25}, Vec3{24, 20, 30}}, thyroid),
        planOf("Cricoid cartilage", PartRole::Larynx, "FMA9615", frame,
               {Vec3{-20, -18, -30}, Vec3{20, 19, 0}},
               [radii](const Vec3& p) { return cricoid(p, radii); }),
        onSide("Left arytenoid cartilage", "FMA55114", frame, 1.0, arytenoid),
        onSide("Right arytenoid cartilage", "FMA55113", frame, -1.0, arytenoid),
        onSide("Left vocal ligament", "FMA55246", frame, 1.0, cord),
        onSide("Right vocal ligament", "FMA55245", frame, -1.0, cord),
        planOf(
            "Epiglottis", PartRole::Epiglottis, "FMA55130", frame, leaf.bounds(),
            [leaf](const Vec3& p) { return leaf.distance(p); }, kEpiglottisVoxel),
        hyoid(plan, frame, leaf),
        vallecula(frame, leaf)};
    for (PartPlan& part : laryngealMucosa(plan, frame, leaf))
        parts.push_back(std::move(part));
    return parts;
}

} // namespace carina
