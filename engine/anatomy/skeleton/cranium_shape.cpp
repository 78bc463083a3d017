#include "engine/anatomy/skeleton/cranium_shape.h"

#include "engine/anatomy/shapes/strand.h"
#include "engine/anatomy/skeleton/maxilla_shape.h"
#include "engine/anatomy/skeleton/spine_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace carina
{
namespace
{

/// Both halves are one half mirrored, x above zero.

constexpr Length kCraniumVoxel = millimetres(2.9);
constexpr double kBesideMaxilla = 0.8;

/// The reference man's braincase: half its width, length and height, its front and its foot.
constexpr double kHalfBreadth = 75.5;
constexpr double kHalfLength = 97.0;
constexpr double kHalfHeight = 78.5;
constexpr double kForehead = 4.0;
constexpr double kFoot = 26.0;
constexpr double kSectionExponent = 2.4; ///< exponent of its sections

/// Height of the base in front of the occipital bone, above the joints of the jaw.
constexpr double kBase = 56.0;
/// The vault of the pharynx, below which nothing of the base reaches down.
constexpr double kAbovePharynx = 47.0;

/// A rod along a line with a radius for each point, written in place.
struct RodPoint {
    Vec3 p;
    double radius;
};
double rods(const Vec3& p, std::span<const RodPoint> points)
{
    double nearest = 1e3;
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
        nearest = std::min(nearest, rodDistance(p, points[i].p, points[i + 1].p, points[i].radius,
                                                points[i + 1].radius));
    return nearest;
}

/// The upper and outer edge of an orbit, down to the zygomatic bone.
double orbitEdge(const Vec3& p)
{
    static const std::array edge{RodPoint{{0, 11, 79}, 7.5},  RodPoint{{14, 11, 84}, 7.0},
                                 RodPoint{{30, 14, 88}, 6.5}, RodPoint{{45, 20, 85}, 6.0},
                                 RodPoint{{52, 28, 75}, 5.2}, RodPoint{{53, 30, 62}, 5.0},
                                 RodPoint{{49, 27, 50}, 6.5}};
    return rods(p, edge);
}

/// The zygomatic bone from the maxilla, and its arch.
double zygomatic(const Vec3& p)
{
    static const std::array arch{RodPoint{{39, 17, 42}, 6.5}, RodPoint{{47, 23, 44}, 7.5},
                                 RodPoint{{56, 35, 46}, 5.5}, RodPoint{{62, 50, 49}, 4.2},
                                 RodPoint{{63, 66, 53}, 3.8}, RodPoint{{61, 82, 58}, 4.2},
                                 RodPoint{{56, 96, 61}, 5.5}};
    return rods(p, arch);
}

double nasalBones(const Vec3& p)
{
    static const std::array bone{RodPoint{{1.5, 9, 80}, 5.5}, RodPoint{{3, 1, 67}, 4.4},
                                 RodPoint{{3.5, -6.5, 54}, 3.0}};
    return rods(p, bone);
}

/// Behind the outer edge of the orbit, where the temporal muscle lies.
double temporalFossa(const Vec3& p)
{
    return ellipsoidDistance(p - Vec3{70.0, 50.0, 64.0}, {22.0, 24.0, 28.0});
}

double mastoid(const Vec3& p) { return rodDistance(p, {51, 104, 58}, {50, 108, 31}, 12.0, 6.0); }

} // namespace

double orbitDistance(const Vec3& p)
{
    return rodDistance({std::abs(p.x()), p.y(), p.z()}, {39.0, -12.0, 66.0}, {20.0, 52.0, 62.0},
                       24.0, 5.5);
}

Cranium::Cranium(const BodyPlan& plan)
    : m_share(0.91 * (1.0 + 0.6 * std::exp(-plan.dimensions.ageInYears / 4.0))),
      m_centre(0.0, kForehead + m_share * kHalfLength, kFoot + m_share * kHalfHeight),
      m_radii(m_share * Vec3{kHalfBreadth, kHalfLength, kHalfHeight}),
      m_atlas((atlasOf(plan) - plan.inFace(Vec3::Zero())) / plan.face),
      m_vertebra(plan.airway / plan.face),
      m_vault((plan.landmarks.p_A_glottis - plan.landmarks.p_A_incisors).y() / plan.face + 14.0)
{
}

double Cranium::braincase(const Vec3& p) const
{
    const Vec3 q = (p - m_centre).cwiseQuotient(m_radii).cwiseAbs();
    const double sum = std::pow(q.x(), kSectionExponent) + std::pow(q.y(), kSectionExponent)
                       + std::pow(q.z(), kSectionExponent);
    return (std::pow(sum, 1.0 / kSectionExponent) - 1.0) * m_radii.x();
}

/// The braincase above the base: in front level with the roofs of the orbits' backs and the joints
/// of the jaw, behind as deep as it is round. The clivus leads down to the foramen.
double Cranium::base(const Vec3& p) const
{
    const double from = std::max(92.0, m_atlas.y() - 24.0);
    const double floor = kBase - 40.0 * easedStep(from, from + 36.0, p.y());
    const double cut = roundedMax(braincase(p), 0.6 * (floor - p.z()), 8.0);
    const double hollowed = roundedMax(cut, -temporalFossa(p), 8.0);
    const double clivus =
        rodDistance(p, {0.0, 66.0, 60.0}, {0.0, m_atlas.y() - 15.0, 41.0}, 11.0, 8.5);
    return roundedMin(hollowed, clivus, 8.0);
}

/// The condyles on the atlas, and the plate around the foramen that they stand on.
double Cranium::onAtlas(const Vec3& p) const
{
    constexpr double kApart = 0.8; ///< from the atlas
    constexpr double kRadius = 6.0;
    const double u = m_vertebra;
    const double foot = m_atlas.z() + 9.0 * u + kApart + kRadius;
    const Vec3 condyle{16.0 * u, m_atlas.y() - 5.0 * u, foot};
    const double condyles =
        rodDistance(p, condyle, {17.0, m_atlas.y() - 1.0, foot + 16.0}, kRadius, 9.0);
    const double plate =
        ellipsoidDistance(p - Vec3{0.0, m_atlas.y() + 6.0, foot + 8.0}, {28.0, 25.0, 11.0});
    return roundedMin(condyles, plate, 6.0);
}

double Cranium::distance(const Vec3& p_mm) const
{
    const Vec3 p{std::abs(p_mm.x()), p_mm.y(), p_mm.z()};
    double d = roundedMin(base(p), onAtlas(p), 8.0);
    d = roundedMin(d, mastoid(p), 8.0);
    d = roundedMin(d, orbitEdge(p), 9.0);
    d = roundedMin(d, nasalBones(p), 5.0);
    d = roundedMin(d, zygomatic(p), 6.0);
    d = roundedMax(d, -orbitDistance(p), 2.5);
    // The foramen is as deep as can be seen into it.
    const Vec2 inForamen{p.x(), p.y() - m_atlas.y() - 11.0};
    const double foramen = std::max(ellipseDistance(inForamen, {15.0, 17.5}),
                                    p.z() - m_atlas.z() - 9.0 * m_vertebra - 20.0);
    d = roundedMax(d, -foramen, 3.0);
    const double throat = std::max({p.x() - 30.0, p.y() - m_vault, p.z() - kAbovePharynx});
    d = roundedMax(d, -throat, 4.0);
    return roundedMax(d, kBesideMaxilla - maxillaDistance(p), 2.0);
}

Box Cranium::bounds() const
{
    const double side = m_radii.x() + 4.0;
    // In infants the condyles follow the atlas down.
    const double foot = std::min(18.0, m_atlas.z() + 9.0 * m_vertebra - 4.0);
    return {Vec3{-side, -12.0, foot},
            Vec3{side, m_centre.y() + m_radii.y() + 4.0, m_centre.z() + m_radii.z() + 4.0}};
}

PartPlan cranium(const BodyPlan& plan)
{
    const Cranium bone{plan};
    const Box box = bone.bounds();
    const auto distance = [bone, origin = plan.inFace(Vec3::Zero()),
                           unit = plan.face](const Vec3& p_A) {
        return unit * bone.distance((p_A - origin) / unit);
    };
    return {"Cranium",
            PartRole::Skull,
            "FMA46565",
            {{plan.inFace(box.min), plan.inFace(box.max)}, distance},
            1e3 * plan.face * kCraniumVoxel};
}

} // namespace carina
