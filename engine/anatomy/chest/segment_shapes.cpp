#include "engine/anatomy/chest/segment_shapes.h"

#include "engine/anatomy/shapes/strand.h"

#include <array>

namespace carina
{

namespace
{

constexpr Length kSegmentVoxel = millimetres(1.5);

/// A segmental bronchus: the rod of its side that it leaves, where, and its end in reference
/// millimetres (BodyPlan) from the lowest edge of the trachea; right ones have x below zero.
struct SegmentFigures {
    const char* name;
    const char* concept_;
    Side side;
    std::size_t rod;
    double along; ///< share of the rod
    Vec3 end;
    double radius; ///< at its beginning
};

const std::array kSegments{
    SegmentFigures{"Right apical", "FMA68211", Side::Right, 1, 0.85, {-41, -10, 50}, 3.0},
    SegmentFigures{"Right posterior", "FMA68213", Side::Right, 1, 1.0, {-70, 34, 30}, 3.0},
    SegmentFigures{"Right anterior", "FMA68212", Side::Right, 1, 0.95, {-50, -60, -20}, 3.2},
    SegmentFigures{"Lateral", "FMA68215", Side::Right, 3, 1.0, {-100, -45, -80}, 2.6},
    SegmentFigures{"Medial", "FMA68214", Side::Right, 3, 1.0, {-53, -72, -92}, 2.6},
    SegmentFigures{"Right superior", "FMA68216", Side::Right, 2, 0.55, {-66, 50, -28}, 3.0},
    SegmentFigures{"Right medial basal", "FMA68218", Side::Right, 2, 0.8, {-15, -11, -71}, 2.4},
    SegmentFigures{"Right anterior basal", "FMA68321", Side::Right, 2, 0.95, {-101, 4, -85}, 2.8},
    SegmentFigures{"Right lateral basal", "FMA68220", Side::Right, 2, 1.0, {-104, 10, -128}, 2.8},
    SegmentFigures{"Right posterior basal", "FMA68221", Side::Right, 2, 1.0, {-54, 38, -140}, 3.0},
    SegmentFigures{"Left apical", "FMA68223", Side::Left, 1, 0.9, {36, -12, 58}, 2.8},
    SegmentFigures{"Left posterior", "FMA68225", Side::Left, 1, 1.0, {75, 24, 32}, 2.8},
    SegmentFigures{"Left anterior", "FMA68222", Side::Left, 1, 1.0, {61, -72, -32}, 3.0},
    SegmentFigures{"Superior lingular", "FMA68226", Side::Left, 3, 1.0, {102, -44, -58}, 2.6},
    SegmentFigures{"Inferior lingular", "FMA68227", Side::Left, 3, 1.0, {76, -86, -103}, 2.6},
    SegmentFigures{"Left superior", "FMA68228", Side::Left, 2, 0.35, {44, 44, 2}, 3.0},
    SegmentFigures{
        "Left anteromedial basal", "FMA68231", Side::Left, 2, 0.9, {112, -30, -112}, 3.0},
    SegmentFigures{"Left lateral basal", "FMA68232", Side::Left, 2, 1.0, {112, -4, -140}, 2.8},
    SegmentFigures{"Left posterior basal", "FMA68233", Side::Left, 2, 1.0, {66, 45, -144}, 3.0}};

PartPlan planOf(const SegmentFigures& s, const BodyPlan& plan, const AirwaySolid& airway)
{
    constexpr int kPieces = 9;
    constexpr double kTaper = 0.55;
    const RigidTransform X_AW = windpipeInAnatomy();
    const AirwayRod& rod = airway.rods(s.side)[s.rod];
    const Vec3 from = X_AW * (rod.p_W_from + s.along * (rod.p_W_to - rod.p_W_from));
    const Vec3 parent = X_AW.rotation() * (rod.p_W_to - rod.p_W_from).normalized();
    const Vec3 end = plan.inChest(s.end);
    const double reach = (end - from).norm();
    std::vector<Vec3> line =
        smoothLine(from, 0.7 * reach * parent, end, 1.1 * (end - from), kPieces);
    line.push_back(end);
    const double radius = s.radius * plan.airway;
    std::vector<double> radii;
    Box bounds;
    for (std::size_t i = 0; i < line.size(); ++i) {
        radii.push_back(radius * (1.0 - (1.0 - kTaper) * double(i) / double(kPieces)));
        bounds.include(line[i] - Vec3::Constant(radius));
        bounds.include(line[i] + Vec3::Constant(radius));
    }
    return {std::string{s.name} + " segmental bronchus",
            PartRole::BronchialTree,
            s.concept_,
            {bounds, [line, radii](const Vec3& p_A) { return tubeDistance(p_A, line, radii); }},
            1e3 * plan.airway * kSegmentVoxel};
}

} // namespace

std::vector<PartPlan> segmentalBronchi(const BodyPlan& plan, const AirwaySolid& airway)
{
    std::vector<PartPlan> parts;
    for (const SegmentFigures& segment : kSegments)
        parts.push_back(planOf(segment, plan, airway));
    return parts;
}

} // namespace carina
