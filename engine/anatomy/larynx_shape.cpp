#include "engine/anatomy/larynx_shape.h"

#include "engine/anatomy/airway_shapes.h"

#include <array>
#include <cmath>

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
    return cornersCut({Vec2{0.0, -21.0}, Vec2{2.5, -20.2}, Vec2{8.0, -13.0}, Vec2{14.0, -3.0},
                       Vec2{18.0, 6.0}, Vec2{19.5, 13.0}},
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

double cordsAndArytenoids(const Vec3& p)
{
    const Vec3 q{std::abs(p.x()), p.y(), p.z()};
    const double cord = rodDistance(q, {1.2, -17.5, 0.0}, {8.5, 7.0, 0.0}, 1.3, 1.7);
    const double arytenoid = rodDistance(q, {8.0, 8.0, -6.0}, {5.0, 10.5, 8.0}, 3.6, 1.6);
    return roundedMin(cord, arytenoid, 2.0);
}

/// A leaf, folded along its middle, that leans forward.
double epiglottis(const Vec3& p)
{
    const double up = p.z() - 3.0;
    const double middle = -16.5 - 0.10 * up + 0.028 * p.x() * p.x();
    const double thickness = std::abs(p.y() - middle) / 1.2 - 1.5;
    const double halfWidth = 2.5 + 8.5 * easedStep(0.0, 26.0, up);
    const double top = 34.0 - 0.06 * p.x() * p.x();
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

} // namespace

ImplicitShape larynxShape(const PatientDimensions& dimensions)
{
    const Larynx larynx{dimensions};
    const Vec2 radii =
        Vec2{0.5 * dimensions.tracheaCoronal.si, 0.5 * dimensions.tracheaSagittal.si} / larynx.unit;
    const auto distance = [larynx, radii](const Vec3& p_A) {
        const Vec3 p = larynx.local(p_A);
        const double cartilages = std::min(thyroid(p), cricoid(p, radii));
        return larynx.unit * roundedMin(cartilages, cordsAndArytenoids(p), 1.5);
    };
    return {larynx.bounds({-25.0, -27.0, -30.0}, {25.0, 19.0, 34.0}), distance};
}

ImplicitShape epiglottisShape(const PatientDimensions& dimensions)
{
    const Larynx larynx{dimensions};
    const auto distance = [larynx](const Vec3& p_A) {
        return larynx.unit * epiglottis(larynx.local(p_A));
    };
    return {larynx.bounds({-15.0, -26.0, 0.0}, {15.0, -8.0, 42.0}), distance};
}

} // namespace carina
