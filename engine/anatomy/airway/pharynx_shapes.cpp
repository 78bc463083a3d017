#include "engine/anatomy/airway/pharynx_shapes.h"

#include "engine/anatomy/airway/airway_shapes.h"
#include "engine/anatomy/shapes/strand.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace carina
{

namespace
{

constexpr Length kPharynxVoxel = millimetres(1.8);
constexpr Length kOesophagusVoxel = millimetres(2.0);
constexpr double kHalfWall = 1.7;

/// A horizontal section of the wall, in reference millimetres (BodyPlan) from between the vocal
/// cords: half its width, its rearmost y, and the y at which it begins in front.
struct WallSection {
    double z, halfWidth, back, front;
};

constexpr std::array kWall{
    WallSection{-21, 11, 21.5, 9},  WallSection{-10, 15, 20.5, 8}, WallSection{0, 17, 19.5, 8},
    WallSection{10, 17.5, 18, 8},   WallSection{20, 17.5, 17, 2},  WallSection{30, 18, 16, -10},
    WallSection{40, 18, 15, -4},    WallSection{47, 20, 13, -4},   WallSection{54, 28, 12, -14},
    WallSection{65, 29, 11.5, -14}, WallSection{78, 26, 11, -8},   WallSection{90, 14, 10, 5}};

WallSection sectionAt(double z)
{
    const auto above = std::ranges::upper_bound(kWall, z, {}, &WallSection::z);
    if (above == kWall.begin())
        return kWall.front();
    if (above == kWall.end())
        return kWall.back();
    const WallSection& b = *above;
    const WallSection& a = *(above - 1);
    const double t = (z - a.z) / (b.z - a.z);
    const auto mix = [t](double from, double to) { return from + t * (to - from); };
    return {z, mix(a.halfWidth, b.halfWidth), mix(a.back, b.back), mix(a.front, b.front)};
}

double wall(const Vec3& p)
{
    const WallSection s = sectionAt(p.z());
    // Half an ellipse whose middle lies where the wall is widest.
    const double middle = std::max(s.back - 0.9 * s.halfWidth, s.front);
    const double shell = std::abs(ellipseDistance({p.x(), std::max(p.y() - middle, 0.0)},
                                                  {s.halfWidth, s.back - middle}))
                         - kHalfWall;
    const double ends = std::max(kWall.front().z - p.z(), p.z() - kWall.back().z);
    return 0.8 * roundedMax(shell, std::max(s.front - p.y(), ends), 1.5);
}

/// Where the pharynx of a patient lies: below the vocal cords by the size of the larynx, from there
/// to the level of the incisors by the height between them, above by the size of the face.
class PharynxPlace
{
public:
    explicit PharynxPlace(const BodyPlan& plan)
        : m_cords(plan.landmarks.p_A_glottis),
          m_larynx(plan.airway),
          m_face(plan.face),
          m_between((plan.landmarks.p_A_incisors.z() - m_cords.z()) / kIncisors)
    {
    }

    /// To reference millimetres, origin between the vocal cords.
    [[nodiscard]] Vec3 inHis(const Vec3& p_A) const
    {
        const Vec3 p = p_A - m_cords;
        const double over = p.z() - m_between * kIncisors;
        const double z = p.z() < 0.0  ? p.z() / m_larynx
                         : over < 0.0 ? p.z() / m_between
                                      : kIncisors + over / m_face;
        return {p.x() / breadthAt(z), p.y() / breadthAt(z), z};
    }

    [[nodiscard]] Vec3 inAnatomy(const Vec3& p_mm) const
    {
        const double z = p_mm.z();
        const double height = z < 0.0         ? z * m_larynx
                              : z < kIncisors ? z * m_between
                                              : kIncisors * m_between + (z - kIncisors) * m_face;
        return m_cords + Vec3{breadthAt(z) * p_mm.x(), breadthAt(z) * p_mm.y(), height};
    }

    /// The smallest of the scales, in metres per reference millimetre.
    [[nodiscard]] double least() const { return std::min({m_larynx, m_face, m_between}); }

private:
    static constexpr double kIncisors = 48.6; ///< the upper incisors' edge above the cords

    [[nodiscard]] double breadthAt(double z) const
    {
        return m_larynx + (m_face - m_larynx) * std::clamp(z / kIncisors, 0.0, 1.0);
    }

    Vec3 m_cords;
    double m_larynx, m_face, m_between;
};

/// One constrictor: the wall between two heights, a little apart from the next.
PartPlan constrictor(const char* name, const char* concept_, double from, double to,
                     const BodyPlan& plan)
{
    constexpr double kApart = 0.6;
    const PharynxPlace place{plan};
    Box bounds;
    for (const double z : {from - 3, to + 3})
        for (const Vec3& corner : {Vec3{-36, -20, z}, Vec3{36, 28, z}})
            bounds.include(place.inAnatomy(corner));
    const auto distance = [from, to, place](const Vec3& p_A) {
        const Vec3 p = place.inHis(p_A);
        const double band = std::max(from + kApart - p.z(), p.z() - to + kApart);
        return place.least() * roundedMax(wall(p), band, 1.0);
    };
    return {
        name, PartRole::Pharynx, concept_, {bounds, distance}, 1e3 * plan.airway * kPharynxVoxel};
}

/// Centre line of the oesophagus from the cricoid to the diaphragm, in reference millimetres of the
/// chest.
constexpr std::array<std::array<double, 3>, 12> kOesophagus{{{0, -12, 102},
                                                             {0, -9, 75},
                                                             {0, -6, 50},
                                                             {0, 0, 25},
                                                             {0.5, 9, 0},
                                                             {0.5, 11, -25},
                                                             {0.5, 11, -50},
                                                             {0.5, 9.5, -75},
                                                             {1, 4, -100},
                                                             {4, -5.5, -125},
                                                             {9, -19, -150},
                                                             {14, -31, -168}}};

PartPlan oesophagus(const BodyPlan& plan)
{
    constexpr double kWide = 8.2;
    constexpr double kThin = 4.4;
    const RigidTransform X_WA = windpipeInAnatomy().inverse();
    const double top = plan.dimensions.tracheaLength.si - 2.0 * plan.airway;
    std::vector<Vec3> line;
    for (const auto& p : kOesophagus) {
        Vec3 p_A = plan.inChest({p[0], p[1], p[2]});
        if (p[2] >= 0.0) { // behind the trachea, from the level of the cricoid down
            const double height = top * p[2] / kOesophagus.front()[2];
            const double behind =
                0.5 * plan.dimensions.tracheaSagittal.si + (kThin + 1.0) * plan.airway;
            const Vec3 p_W{p_A.x(), behind, height};
            const Vec3 there = X_WA.inverse() * p_W;
            p_A = {there.x(), std::max(there.y(), p_A.y()), there.z()};
        }
        line.push_back(p_A);
    }
    std::vector<StrandPoint> points;
    const std::vector<Vec3> smooth = smoothThrough(line, 4);
    for (std::size_t i = 0; i < smooth.size(); ++i) {
        const Vec3 along = smooth[std::min(i + 1, smooth.size() - 1)] - smooth[i > 0 ? i - 1 : 0];
        points.push_back({smooth[i], kWide * plan.chest, kThin * plan.chest,
                          along.cross(Vec3::UnitX()).normalized()});
    }
    return {"Oesophagus", PartRole::Oesophagus, "FMA7131", Strand{std::move(points)}.shape(),
            1e3 * plan.chest * kOesophagusVoxel};
}

} // namespace

std::vector<PartPlan> pharynxAndOesophagus(const BodyPlan& plan)
{
    return {constrictor("Superior pharyngeal constrictor", "FMA46621", 47, 92, plan),
            constrictor("Middle pharyngeal constrictor", "FMA46622", 26, 47, plan),
            constrictor("Inferior pharyngeal constrictor", "FMA46623", -22, 26, plan),
            oesophagus(plan)};
}

} // namespace carina
