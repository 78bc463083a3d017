#include "engine/anatomy/skeleton/rib_shapes.h"

#include "engine/anatomy/shapes/strand.h"

#include <string>

namespace carina
{

namespace
{

constexpr Length kRibVoxel = millimetres(3.2);
constexpr Length kSternumVoxel = millimetres(2.2);

/// Four places on the middle of a left rib: beside its vertebra, furthest back, furthest to the
/// side, and where its bone ends. x of the first is 15 mm, of the second 0.54 of the third's.
struct RibFigures {
    double headY, headZ;
    double backY, backZ;
    double sideX, sideY, sideZ;
    double endX, endY, endZ;
};

constexpr std::array kRibs{
    RibFigures{7, 76, 14, 79, 59, -12, 52, 37, -45, 31},
    RibFigures{12, 64, 24, 65, 86, -17, 31, 46, -80, -5},
    RibFigures{26, 44, 40, 41, 103, -19, 2, 50, -92, -34},
    RibFigures{31, 23, 53, 17, 112, -24, -31, 58, -104, -66},
    RibFigures{38, -2, 63, -12, 122, -20, -66, 77, -111, -105},
    RibFigures{42, -26, 72, -42, 129, -16, -100, 86, -108, -137},
    RibFigures{46, -54, 73, -72, 132, -20, -136, 106, -92, -170},
    RibFigures{43, -81, 73, -104, 128, -28, -176, 116, -74, -202},
    RibFigures{37, -105, 68, -134, 124, -14, -208, 117, -50, -230},
    RibFigures{31, -134, 65, -168, 119, -4, -240, 116, -32, -254},
    RibFigures{24, -170, 58, -198, 101, 0, -261, 99, -10, -268},
    RibFigures{22, -204, 52, -226, 76, 24, -260, 75, 18, -265},
};

/// Where the cartilages of the first seven ribs meet the sternum, and where they bend on the way.
struct CartilageFigures {
    Vec3 atSternum;
    Vec3 bend;
};

const std::array kCartilages{
    CartilageFigures{{22, -62, 19}, {31, -55, 24}},
    CartilageFigures{{14, -89, -7}, {30, -87, -7}},
    CartilageFigures{{15, -103, -34}, {33, -101, -35}},
    CartilageFigures{{15, -112, -57}, {36, -113, -66}},
    CartilageFigures{{17, -118, -77}, {52, -122, -105}},
    CartilageFigures{{14, -122, -88}, {56, -124, -142}},
    CartilageFigures{{6, -127, -102}, {56, -128, -164}},
};

constexpr std::array kOrdinals{"first",   "second", "third", "fourth", "fifth",    "sixth",
                               "seventh", "eighth", "ninth", "tenth",  "eleventh", "twelfth"};
/// Concepts of the Foundational Model of Anatomy, left and right.
constexpr std::array<std::array<int, 2>, 12> kRibConcepts{{{7987, 7857},
                                                           {8012, 7882},
                                                           {8039, 7909},
                                                           {8148, 7957},
                                                           {8093, 8066},
                                                           {8202, 8175},
                                                           {8256, 8229},
                                                           {8310, 8283},
                                                           {8391, 8364},
                                                           {8472, 8445},
                                                           {8532, 8531},
                                                           {8534, 8533}}};
constexpr std::array<std::array<int, 2>, 7> kCartilageConcepts{{{8005, 7875},
                                                                {8031, 7886},
                                                                {8058, 7913},
                                                                {8167, 7976},
                                                                {8112, 8070},
                                                                {8221, 8194},
                                                                {8275, 8248}}};

Vec3 endOf(const RibFigures& rib) { return {rib.endX, rib.endY, rib.endZ}; }

/// The line on one side, in A.
std::vector<Vec3> placed(const std::vector<Vec3>& line_mm, Side side, const BodyPlan& plan)
{
    const double sign = side == Side::Right ? -1.0 : 1.0;
    std::vector<Vec3> line;
    for (const Vec3& p : line_mm)
        line.push_back(plan.inChest({sign * p.x(), p.y(), p.z()}));
    return line;
}

/// A flat strand along a line in A; ribs are thin across the chest's wall: in the direction that is
/// perpendicular to the line and nearest to horizontal.
Strand ribStrand(const std::vector<Vec3>& line_A, double wide, double thin)
{
    std::vector<StrandPoint> points;
    for (std::size_t i = 0; i < line_A.size(); ++i) {
        const Vec3 along = line_A[std::min(i + 1, line_A.size() - 1)] - line_A[i > 0 ? i - 1 : 0];
        points.push_back({line_A[i], wide, thin, along.cross(Vec3::UnitZ()).normalized()});
    }
    return Strand{std::move(points)};
}

std::string sided(Side side, const std::string& rest)
{
    return (side == Side::Right ? "Right " : "Left ") + rest;
}

std::string fma(int number) { return "FMA" + std::to_string(number); }

PartPlan rib(std::size_t i, Side side, const BodyPlan& plan)
{
    // The first rib lies flat on the apex of the lung, the last two are slender.
    const double wide = i == 0 ? 8.0 : i >= 10 ? 6.0 : 7.4;
    Strand strand = ribStrand(placed(ribLine(i), side, plan), wide * plan.chest, 3.5 * plan.chest);
    return {sided(side, std::string{kOrdinals[i]} + " rib"), PartRole::Rib,
            fma(kRibConcepts[i][side == Side::Right ? 1 : 0]), strand.shape(),
            1e3 * plan.chest * kRibVoxel};
}

PartPlan cartilage(std::size_t i, Side side, const BodyPlan& plan)
{
    const std::array through{endOf(kRibs[i]), kCartilages[i].bend, kCartilages[i].atSternum};
    Strand strand = ribStrand(placed(smoothThrough(through, 6), side, plan), 7.0 * plan.chest,
                              4.6 * plan.chest);
    return {sided(side, std::string{kOrdinals[i]} + " costal cartilage"), PartRole::Rib,
            fma(kCartilageConcepts[i][side == Side::Right ? 1 : 0]), strand.shape(),
            1e3 * plan.chest * kRibVoxel};
}

struct PlateFigures {
    Vec3 p;
    double wide;
    double thin;
};

/// A plate in the midline, thin from front to back, through places from one end to the other.
template <std::size_t n>
PartPlan plate(const char* name, int concept_, const std::array<PlateFigures, n>& places,
               const BodyPlan& plan)
{
    std::vector<StrandPoint> points;
    for (std::size_t i = 0; i < n; ++i) {
        const Vec3 along = places[std::min(i + 1, n - 1)].p - places[i > 0 ? i - 1 : 0].p;
        points.push_back({plan.inChest(places[i].p), places[i].wide * plan.chest,
                          places[i].thin * plan.chest, along.cross(Vec3::UnitX()).normalized()});
    }
    return {name, PartRole::Rib, fma(concept_), Strand{std::move(points)}.shape(),
            1e3 * plan.chest * kSternumVoxel};
}

const std::array kManubrium{PlateFigures{{0, -84, 2}, 15.0, 6.0},
                            PlateFigures{{0, -74, 10}, 20.0, 6.0},
                            PlateFigures{{0, -61, 22}, 25.0, 6.0}};
const std::array kSternum{
    PlateFigures{{0, -93, -12}, 13.5, 5.0}, PlateFigures{{0, -104, -36}, 15.0, 5.0},
    PlateFigures{{0, -113, -66}, 20.0, 5.0}, PlateFigures{{0, -121, -86}, 18.0, 5.0}};
const std::array kXiphoid{PlateFigures{{0, -124, -106}, 8.0, 4.0},
                          PlateFigures{{0, -124, -117}, 4.0, 3.0}};

/// The outer end of a plate at its last point, in reference millimetres (BodyPlan).
template <std::size_t n> Vec3 tipOf(const std::array<PlateFigures, n>& places)
{
    const PlateFigures& last = places[n - 1];
    return last.p + last.wide * (last.p - places[n - 2].p).normalized();
}

PartPlan clavicle(Side side, const BodyPlan& plan)
{
    const std::array<Vec3, 6> through{Vec3{15, -53, 35}, Vec3{32, -56, 39}, Vec3{66, -37, 47},
                                      Vec3{93, 1, 55},   Vec3{114, 14, 61}, Vec3{138, 15, 63}};
    Strand strand = ribStrand(placed(smoothThrough(through, 5), side, plan), 7.0 * plan.chest,
                              5.5 * plan.chest);
    return {sided(side, "clavicle"), PartRole::Rib, fma(side == Side::Right ? 13322 : 13323),
            strand.shape(), 1e3 * plan.chest * kRibVoxel};
}

} // namespace

std::vector<Vec3> ribLine(std::size_t rib)
{
    const RibFigures& r = kRibs[rib];
    const Vec3 head{15.0, r.headY, r.headZ};
    // Curves through few places run a little inside the rib that they stand for.
    constexpr double kOutward = 2.0;
    const Vec3 back{0.54 * r.sideX, r.backY + kOutward, r.backZ};
    const Vec3 side{r.sideX + kOutward, r.sideY, r.sideZ};
    const Vec3 end = endOf(r);
    // Quarters of ellipses seen from above: the constants are those of a cubic through a quarter
    // and through 60 degrees of one.
    constexpr double kQuarter = 1.657;
    const double downBack = 0.5 * (side.z() - head.z());
    const double downSide = 0.5 * (end.z() - back.z());
    const Vec3 leavingHead{0.6 * (back.x() - head.x()), 1.4 * (back.y() - head.y()),
                           back.z() - head.z()};
    const Vec3 outward{kQuarter * (side.x() - back.x()), 0.0, downBack};
    const Vec3 forward{0.0, kQuarter * (side.y() - back.y()), downSide};
    const Vec3 onward{0.0, 1.209 * (end.y() - side.y()), downSide};
    const Vec3 inward{1.813 * (end.x() - side.x()), 0.605 * (end.y() - side.y()),
                      0.8 * (end.z() - side.z())};
    const Vec3 shortOut{back.x() - head.x(), 0.0, 0.5 * downBack};
    std::vector<Vec3> line = smoothLine(head, leavingHead, back, shortOut, 5);
    for (const auto& piece :
         {smoothLine(back, outward, side, forward, 9), smoothLine(side, onward, end, inward, 8)})
        line.insert(line.end(), piece.begin(), piece.end());
    line.push_back(end);
    return line;
}

RibLandmarks ribLandmarksOf(const BodyPlan& plan)
{
    RibLandmarks marks;
    for (std::size_t i = 0; i < kRibs.size(); ++i) {
        const Vec3 end = endOf(kRibs[i]);
        marks.p_A_leftEnds[i] = plan.inChest(end);
        marks.p_A_rightEnds[i] = plan.inChest({-end.x(), end.y(), end.z()});
    }
    marks.p_A_sternalNotch = plan.inChest(tipOf(kManubrium));
    marks.p_A_xiphoidTip = plan.inChest(tipOf(kXiphoid));
    return marks;
}

std::vector<PartPlan> ribCage(const BodyPlan& plan)
{
    std::vector<PartPlan> parts;
    for (const Side side : {Side::Left, Side::Right}) {
        for (std::size_t i = 0; i < kRibs.size(); ++i)
            parts.push_back(rib(i, side, plan));
        for (std::size_t i = 0; i < kCartilages.size(); ++i)
            parts.push_back(cartilage(i, side, plan));
        parts.push_back(clavicle(side, plan));
    }
    parts.push_back(plate("Manubrium", 7486, kManubrium, plan));
    parts.push_back(plate("Body of sternum", 7487, kSternum, plan));
    parts.push_back(plate("Xiphoid process", 7488, kXiphoid, plan));
    return parts;
}

} // namespace carina
