#include "engine/anatomy/chest/heart_shape.h"

#include "engine/anatomy/shapes/strand.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

namespace carina
{
namespace
{

/// Written in reference millimetres of the chest (BodyPlan).
constexpr Length kHeartVoxel = millimetres(3.0);
constexpr Length kVesselVoxel = millimetres(2.4);
constexpr double kBesideAirway = 1.0;
constexpr double kFarFromHeart = 20.0;

double ventricles(const Vec3& p)
{
    const double right = rodDistance(p, {4, -56, -52}, {44, -67, -80}, 31.0, 17.0);
    const double left = rodDistance(p, {24, -44, -54}, {53.5, -59.5, -82}, 33.0, 17.5);
    return roundedMin(right, left, 2.5);
}

double atria(const Vec3& p)
{
    const double right = ellipsoidDistance(p - Vec3{-12, -40, -46}, {19.0, 25.0, 30.0});
    const double left = ellipsoidDistance(p - Vec3{12, -20, -44}, {31.0, 18.0, 22.0});
    const double rightAuricle = rodDistance(p, {-14, -54, -27}, {3, -66, -23}, 10.0, 6.5);
    const double leftAuricle = rodDistance(p, {38, -32, -32}, {49, -52, -34}, 9.0, 6.5);
    return roundedMin(roundedMin(right, rightAuricle, 4.0), roundedMin(left, leftAuricle, 4.0),
                      3.0);
}

double heartDistance(const Vec3& p) { return roundedMin(ventricles(p), atria(p), 3.5); }

struct VesselPoint {
    Vec3 p;
    double radius;
};

/// From the left ventricle, before the trachea and over the left main bronchus, down beside the
/// vertebrae to the diaphragm.
const std::array kAorta{VesselPoint{{13, -40, -44}, 13.5}, VesselPoint{{8, -43, -25}, 13.8},
                        VesselPoint{{6, -41, -4}, 13.2},   VesselPoint{{10, -31, 12}, 12.8},
                        VesselPoint{{20, -15, 19}, 12.0},  VesselPoint{{25, 5, 16}, 11.0},
                        VesselPoint{{27, 19, 4}, 10.8},    VesselPoint{{27, 24.5, -12}, 10.5},
                        VesselPoint{{25, 19, -30}, 10.5},  VesselPoint{{21.5, 12, -50}, 10.5},
                        VesselPoint{{20.5, 9, -75}, 10.2}, VesselPoint{{20.5, 8, -99}, 10.0}};

/// From the right ventricle to the left of the ascending aorta; its left artery over the left main
/// bronchus, its right one behind the ascending aorta and the vena cava.
const std::array kPulmonaryTrunk{
    VesselPoint{{27, -64, -38}, 12.0}, VesselPoint{{33, -57, -18}, 11.8},
    VesselPoint{{33.5, -43, -7}, 10.5}, VesselPoint{{30, -25, -6}, 9.5}};
const std::array kLeftPulmonaryArtery{VesselPoint{{30, -25, -6}, 9.0},
                                      VesselPoint{{34, -9, -9}, 7.5}};
const std::array kRightPulmonaryArtery{VesselPoint{{30, -25, -6}, 8.0},
                                       VesselPoint{{8, -17, -12}, 7.0},
                                       VesselPoint{{-14, -12, -14}, 6.0}};

const std::array kSuperiorVenaCava{
    VesselPoint{{-13, -27, 30}, 8.0}, VesselPoint{{-14.5, -29, 10}, 8.3},
    VesselPoint{{-15.8, -32, -12}, 8.3}, VesselPoint{{-13, -36, -30}, 9.0}};
const std::array kInferiorVenaCava{VesselPoint{{-13, -37, -64}, 8.5},
                                   VesselPoint{{-13, -33, -87}, 8.5}};

/// A smooth tube through these points.
class Vessel
{
public:
    explicit Vessel(std::span<const VesselPoint> points)
    {
        constexpr int kPieces = 3;
        std::vector<Vec3> through;
        for (const VesselPoint& point : points)
            through.push_back(point.p);
        m_line = smoothThrough(through, kPieces);
        for (std::size_t i = 0; i < m_line.size(); ++i) {
            const std::size_t from = std::min(i / kPieces, points.size() - 2);
            const double share = double(i - from * kPieces) / kPieces;
            m_radii.push_back((1.0 - share) * points[from].radius
                              + share * points[from + 1].radius);
        }
    }

    [[nodiscard]] double distance(const Vec3& p) const { return tubeDistance(p, m_line, m_radii); }

    [[nodiscard]] Box bounds() const
    {
        Box box;
        for (std::size_t i = 0; i < m_line.size(); ++i) {
            box.include(m_line[i] - Vec3::Constant(m_radii[i]));
            box.include(m_line[i] + Vec3::Constant(m_radii[i]));
        }
        return box;
    }

private:
    std::vector<Vec3> m_line;
    std::vector<double> m_radii;
};

struct PulmonaryTrunk {
    Vessel trunk{kPulmonaryTrunk};
    Vessel left{kLeftPulmonaryArtery};
    Vessel right{kRightPulmonaryArtery};

    [[nodiscard]] double distance(const Vec3& p) const
    {
        return roundedMin(trunk.distance(p), std::min(left.distance(p), right.distance(p)), 3.0);
    }
    [[nodiscard]] Box bounds() const
    {
        Box box = trunk.bounds();
        box.include(left.bounds());
        box.include(right.bounds());
        return box;
    }
};

const Box kHeartBounds{Vec3{-36, -96, -106}, Vec3{80, 4, -8}};

} // namespace

std::vector<PartPlan> heartAndVessels(const BodyPlan& plan, const Implicit& airway)
{
    const auto part = [&](const char* name, PartRole role, const char* concept_, const Box& box,
                          Length voxel, Implicit local) {
        const auto distance = [airway, local = std::move(local),
                               origin = plan.inChest(Vec3::Zero()),
                               unit = plan.chest](const Vec3& p_A) {
            const double inside = local((p_A - origin) / unit);
            return unit * roundedMax(inside, kBesideAirway - airway(p_A) / unit, 1.5);
        };
        return PartPlan{name,
                        role,
                        concept_,
                        {{plan.inChest(box.min), plan.inChest(box.max)}, distance},
                        1e3 * plan.chest * voxel};
    };
    const auto vessel = [&](const char* name, const char* concept_, const auto& shape) {
        return part(name, PartRole::Vessel, concept_, shape.bounds(), kVesselVoxel,
                    [shape](const Vec3& p) { return shape.distance(p); });
    };
    return {part("Heart", PartRole::Heart, "FMA7088", kHeartBounds, kHeartVoxel, heartDistance),
            vessel("Aorta", "FMA3734", Vessel{kAorta}),
            vessel("Superior vena cava", "FMA4720", Vessel{kSuperiorVenaCava}),
            vessel("Inferior vena cava", "FMA10951", Vessel{kInferiorVenaCava}),
            vessel("Pulmonary trunk", "FMA8612", PulmonaryTrunk{})};
}

Implicit heartAndVesselsRegion(const BodyPlan& plan)
{
    const PulmonaryTrunk trunk;
    const std::array vessels{Vessel{kAorta}, Vessel{kSuperiorVenaCava}, Vessel{kInferiorVenaCava}};
    Box box = kHeartBounds;
    box.include(trunk.bounds());
    for (const Vessel& vessel : vessels)
        box.include(vessel.bounds());
    return [=, origin = plan.inChest(Vec3::Zero()), unit = plan.chest](const Vec3& p_A) {
        const Vec3 p = (p_A - origin) / unit;
        const double fromBox = std::max((box.min - p).maxCoeff(), (p - box.max).maxCoeff());
        if (fromBox > kFarFromHeart)
            return unit * kFarFromHeart;
        double nearest = std::min(heartDistance(p), trunk.distance(p));
        for (const Vessel& vessel : vessels)
            nearest = std::min(nearest, vessel.distance(p));
        return unit * nearest;
    };
}

} // namespace carina
