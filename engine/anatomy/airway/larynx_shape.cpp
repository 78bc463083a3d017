#include "engine/anatomy/airway/larynx_shape.h"

#include "engine/anatomy/airway/airway_shapes.h"

#include <array>
#include <cmath>
#include <utility>

namespace carina
{

namespace
{

/// Laryngeal shapes are written in millimetres of the adult, in axes of the windpipe's frame with
/// the origin between the vocal cords.

/// How far below the cords the trachea begins, in the adult.
constexpr double kTracheaTop = -26.0;

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
    const double top = kTracheaTop + 7.0 + 14.0 * backward;
    const double slab = std::max(kTracheaTop - p.z(), p.z() - top);
    return roundedMax(ring, slab, 2.0);
}

/// Of the half that p is mirrored into: towards the cord's own side.
double cord(const Vec3& p) { return rodDistance(p, {1.2, -13.5, 0.0}, {8.0, 8.5, 0.0}, 1.3, 1.7); }

double arytenoid(const Vec3& p)
{
    return rodDistance(p, {8.6, 10.6, -5.0}, {5.0, 12.5, 8.0}, 3.4, 1.6);
}

/// A leaf, folded along its middle.
double epiglottis(const Vec3& p, Posture posture)
{
    const bool raised = posture == Posture::Laryngoscopy;
    const double up = p.z() - 3.0;
    const double middle = (raised ? -12.5 - 0.10 * up : -8.0 + 0.36 * up) + 0.024 * p.x() * p.x();
    const double thickness = std::abs(p.y() - middle) / 1.2 - 1.5;
    const double halfWidth = 2.5 + 7.0 * easedStep(0.0, 20.0, up);
    const double top = 33.0 - 0.06 * p.x() * p.x();
    const double leaf = roundedMax(std::abs(p.x()) - halfWidth, std::max(up - top, -up), 6.0);
    return roundedMax(0.8 * leaf, thickness, 1.5);
}

struct Larynx {
    RigidTransform X_WA;
    Vec3 p_W_glottis;
    double unit;

    explicit Larynx(const PatientDimensions& d)
        : X_WA(windpipeInAnatomy().inverse()),
          p_W_glottis(d.cordsToCarina.si * Vec3::UnitZ()),
          unit((d.cordsToCarina.si - d.tracheaLength.si) / -kTracheaTop)
    {
    }

    [[nodiscard]] Vec3 local(const Vec3& p_A) const { return (X_WA * p_A - p_W_glottis) / unit; }

    [[nodiscard]] Box bounds(const Vec3& low, const Vec3& high) const
    {
        Box box;
        for (const double x : {low.x(), high.x()}) {
            for (const double y : {low.y(), high.y()}) {
                for (const double z : {low.z(), high.z()})
                    box.include(X_WA.inverse() * (p_W_glottis + unit * Vec3{x, y, z}));
            }
        }
        return box;
    }
};

constexpr Length kLarynxVoxel = millimetres(1.1);

/// A part written in this file's millimetres within a box, in A.
PartPlan planOf(const char* name, PartRole role, const char* concept_, const Larynx& larynx,
                const Box& box, Implicit local)
{
    const auto distance = [larynx, local = std::move(local)](const Vec3& p_A) {
        return larynx.unit * local(larynx.local(p_A));
    };
    return {name,
            role,
            concept_,
            {larynx.bounds(box.min, box.max), distance},
            1e3 * larynx.unit * kLarynxVoxel};
}

PartPlan onSide(const char* name, const char* concept_, const Larynx& larynx, double sign,
                double (*half)(const Vec3&))
{
    const Box box{Vec3{sign > 0.0 ? 0.0 : -15.0, -17.0, -10.0},
                  Vec3{sign > 0.0 ? 15.0 : 0.0, 18.0, 12.0}};
    return planOf(name, PartRole::Larynx, concept_, larynx, box, [sign, half](const Vec3& p) {
        return half({sign * p.x(), p.y(), p.z()});
    });
}

} // namespace

std::vector<PartPlan> larynx(const BodyPlan& plan)
{
    const PatientDimensions& d = plan.dimensions;
    const Larynx larynx{d};
    const Vec2 radii = Vec2{0.5 * d.tracheaCoronal.si, 0.5 * d.tracheaSagittal.si} / larynx.unit;
    return {planOf("Thyroid cartilage", PartRole::Larynx, "FMA55099", larynx,
                   {Vec3{-24, -21, -25}, Vec3{24, 20, 30}}, thyroid),
            planOf("Cricoid cartilage", PartRole::Larynx, "FMA9615", larynx,
                   {Vec3{-20, -18, -30}, Vec3{20, 19, 0}},
                   [radii](const Vec3& p) { return cricoid(p, radii); }),
            onSide("Left arytenoid cartilage", "FMA55114", larynx, 1.0, arytenoid),
            onSide("Right arytenoid cartilage", "FMA55113", larynx, -1.0, arytenoid),
            onSide("Left vocal ligament", "FMA55246", larynx, 1.0, cord),
            onSide("Right vocal ligament", "FMA55245", larynx, -1.0, cord),
            planOf("Epiglottis", PartRole::Epiglottis, "FMA55130", larynx,
                   {Vec3{-15, -22, 0}, Vec3{15, 12, 40}},
                   [posture = plan.posture](const Vec3& p) { return epiglottis(p, posture); })};
}

} // namespace carina
