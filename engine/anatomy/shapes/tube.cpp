#include "engine/anatomy/shapes/tube.h"

#include "engine/anatomy/airway/centreline.h"
#include "engine/anatomy/shapes/swept_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace carina
{
namespace
{

constexpr double kOutside = 0.05;      ///< metres of tube in front of the incisors
constexpr double kStep = 0.004;        ///< between rings of the tube's wall, metres
constexpr double kRounded = 0.003;     ///< of the tip, metres
constexpr double kRim = 0.8;           ///< its radius, of the tube's
constexpr double kBevel = 2.0;         ///< its length in radii of the tube: 45 degrees; of ours
constexpr double kMarkRise = 0.00015;  ///< of a depth mark above the wall
constexpr double kCuffFromTip = 0.015; ///< metres, to its lower end
constexpr double kCuffLength = 0.032;
constexpr double kCuffSwell = 1.25;        ///< of the tube's radius: fills a trachea the tube fits
constexpr double kFlatCuff = 1.03;         ///< likewise, of an empty one
constexpr double kFullCuffRadius = 0.0034; ///< of a tube of 5.0 mm; thinner ones have shorter cuffs
constexpr double kConnectorLength = 0.02;
constexpr double kConnectorRadius = 0.0075; ///< ISO 5356: 15 mm
constexpr double kFlangeRadius = 0.0105;

/// Arc length at which the line comes nearest to a point.
double nearestAlong(const SweptLine& line, const Vec3& p)
{
    const auto nearest = std::ranges::min_element(
        line.points, {}, [&](const Vec3& point) { return (point - p).squaredNorm(); });
    return line.along[std::size_t(nearest - line.points.begin())];
}

/// The tip is cut obliquely and opens to the patient's left, as that of tubes that are sold: the
/// wall there is drawn back, by nothing at the rim on the right and by kBevel across the tube on
/// the left.
void bevel(TriangleMesh& wall, const SweptLine& tube, double radius)
{
    const double reach = 2.0 * kBevel * radius; // within which it is
    const Vec3 along = tube.tangents.back();
    const Vec3 left = (Vec3::UnitX() - along.x() * along).normalized();
    for (std::size_t i = 0; i < wall.positions.size(); ++i) {
        const Vec3 p = wall.positions[i].cast<double>() - tube.points.back();
        const double share = 1.0 + p.dot(along) / reach; // 1 at the tip
        if (share <= 0.0 || p.norm() > 2.0 * reach)
            continue;
        const double most = 0.5 * kBevel * radius * (kRim + p.dot(left) / radius);
        wall.positions[i] -= (share * most * along).cast<float>();
        const Vec3 slope = -0.5 * kBevel * share * left - most / reach * along;
        const Vec3 n = wall.normals[i].cast<double>();
        wall.normals[i] =
            Vec3{n - n.dot(along) / (1.0 + slope.dot(along)) * slope}.normalized().cast<float>();
    }
}

TriangleMesh wall(const SweptLine& tube, double radius)
{
    const double length = tube.along.back();
    std::vector<Ring> rings;
    for (double along = 0.0; along < length - kRounded; along += kStep)
        rings.push_back({along, radius});
    rings.push_back({length - kRounded, radius});
    rings.push_back({length, kRim * radius});
    TriangleMesh mesh = sweptSurface(tube, rings);
    bevel(mesh, tube, radius);
    return mesh;
}

TriangleMesh depthMarks(const SweptLine& tube, double radius)
{
    TriangleMesh marks;
    for (int cm = 5; 0.01 * cm < tube.along.back(); ++cm) {
        const double half = cm % 5 == 0 ? 0.0012 : 0.0005;
        const double middle = tube.along.back() - 0.01 * cm;
        const std::array rings{Ring{middle - half, radius + kMarkRise},
                               Ring{middle + half, radius + kMarkRise}};
        append(marks, sweptSurface(tube, rings));
    }
    return marks;
}

/// @param most of the tube's radius, in its middle
TriangleMesh cuff(const SweptLine& tube, double radius, double most)
{
    constexpr int kRings = 16;
    const double size = std::min(radius / kFullCuffRadius, 1.0);
    std::vector<Ring> rings;
    for (int i = 0; i <= kRings; ++i) {
        const double share = double(i) / kRings;
        // A half sine to the power of one half: full in the middle, steep at both ends.
        const double swell = std::sqrt(std::sin(std::numbers::pi * share));
        rings.push_back({tube.along.back() - size * (kCuffFromTip + kCuffLength * (1.0 - share)),
                         radius * (1.01 + (most - 1.01) * std::max(swell, 0.0))});
    }
    return sweptSurface(tube, rings);
}

TriangleMesh connector(const SweptLine& tube)
{
    const Vec3 start = tube.points.front();
    const std::array ends{Vec3{start - kConnectorLength * tube.tangents.front()}, start};
    const SweptLine line = sweptLine(ends);
    const std::array rings{
        Ring{0.0, kConnectorRadius},         Ring{0.014, kConnectorRadius},
        Ring{0.014, kFlangeRadius},          Ring{0.016, kFlangeRadius},
        Ring{0.016, 0.8 * kConnectorRadius}, Ring{kConnectorLength, 0.7 * kConnectorRadius}};
    return sweptSurface(line, rings);
}

std::vector<TubePiece> piecesOf(const SweptLine& tube, double radius)
{
    return {{"Tube", wall(tube, radius)},
            {"Depth marks", depthMarks(tube, radius)},
            {"Cuff", cuff(tube, radius, kFlatCuff)},
            {kInflatedCuff, cuff(tube, radius, kCuffSwell)},
            {"Connector", connector(tube)}};
}

/// The connector's frame where the tube begins.
RigidTransform connectorPose(const LinePlace& start)
{
    const Vec3 z_A = -start.tangent;
    Vec3 x_A = Vec3::UnitX() - Vec3::UnitX().dot(z_A) * z_A;
    x_A = x_A.norm() > 1e-3 ? Vec3{x_A.normalized()} : z_A.unitOrthogonal();
    Mat3 R_AE;
    R_AE << x_A, z_A.cross(x_A), z_A;
    return {Quat{R_AE}, start.point};
}

TriangleMesh takenTo(TriangleMesh mesh, const RigidTransform& X)
{
    for (Vec3f& p : mesh.positions)
        p = (X * p.cast<double>()).cast<float>();
    for (Vec3f& n : mesh.normals)
        n = (X.rotation() * n.cast<double>()).cast<float>();
    return mesh;
}

/// The line cut where it is so long, or straight on until it is.
std::vector<Vec3> withLength(std::vector<Vec3> line, double length)
{
    double missing = length - lengthOf(line).si;
    while (missing < 0.0 && line.size() > 2) {
        const double last = (line.back() - line[line.size() - 2]).norm();
        if (last > -missing)
            break;
        missing += last;
        line.pop_back();
    }
    line.back() += missing * (line.back() - line[line.size() - 2]).normalized();
    return line;
}

} // namespace

Length outerDiameterOf(Length innerDiameter)
{
    constexpr std::array kInner{6.0, 6.5, 7.0, 7.5, 8.0};
    constexpr std::array kOuter{8.2, 8.9, 9.6, 10.2, 10.9};
    const double inner = inMillimetres(innerDiameter);
    std::size_t i = 0;
    while (i + 2 < kInner.size() && inner > kInner[i + 1])
        ++i;
    const double share = (inner - kInner[i]) / (kInner[i + 1] - kInner[i]);
    return millimetres(kOuter[i] + share * (kOuter[i + 1] - kOuter[i]));
}

Length soldInnerDiameterOf(Length outerDiameter)
{
    constexpr Length kStepOfSizes = millimetres(0.5);
    constexpr int kThinnest = 4; // in such steps
    constexpr int kThickest = 24;
    const auto isOff = [&](Length inner) {
        return std::abs((outerDiameterOf(inner) - outerDiameter).si);
    };
    Length nearest = double(kThinnest) * kStepOfSizes;
    for (int steps = kThinnest + 1; steps <= kThickest; ++steps)
        if (const Length size = double(steps) * kStepOfSizes; isOff(size) < isOff(nearest))
            nearest = size;
    return nearest;
}

Length usualTipAboveCarina(Length innerDiameter)
{
    constexpr Length kUsual = millimetres(30.0);
    constexpr Length kLeastOfChildren = millimetres(5.0);
    return std::min(innerDiameter / kLeastOfChildren, 1.0) * kUsual;
}

Result<TubeShape> makeTube(Length innerDiameter, std::span<const Vec3> path_A,
                           const Vec3& p_A_incisors, Length tipAboveCarina)
{
    const double inner_mm = inMillimetres(innerDiameter);
    if (!(inner_mm >= 2.0 && inner_mm <= 12.0))
        return fail(Errc::OutOfRange, "a tube of " + std::to_string(inner_mm) + " mm");
    if (!(tipAboveCarina.si >= 0.0))
        return fail(Errc::OutOfRange, "the tip of the tube beyond the carina");
    if (path_A.size() < 2)
        return fail(Errc::NoAirway);
    const SweptLine path = sweptLine(path_A);
    const double from = nearestAlong(path, p_A_incisors) - kOutside;
    const double until = path.along.back() - tipAboveCarina.si;
    if (!(from >= 0.0 && until > from + kCuffFromTip + kCuffLength))
        return fail(Errc::NoAirway, "it is too short");

    const RigidTransform X_AE = connectorPose(placeAt(path, from));
    const RigidTransform X_EA = X_AE.inverse();
    std::vector<Vec3> centre;
    const auto steps = static_cast<int>(std::ceil((until - from) / kStep));
    for (int i = 0; i <= steps; ++i)
        centre.push_back(X_EA * placeAt(path, from + (until - from) * i / steps).point);
    const SweptLine tube = sweptLine(centre);
    const Length outer = outerDiameterOf(innerDiameter);
    return TubeShape{.X_AE = X_AE,
                     .p_E_centre = tube.points,
                     .p_E_tip = tube.points.back(),
                     .tipAboveCarina = tipAboveCarina,
                     .innerDiameter = innerDiameter,
                     .outerDiameter = outer,
                     .pieces = piecesOf(tube, 0.5 * outer.si)};
}

TubeShape tubeAlong(const TubeShape& tube, std::span<const Vec3> p_E_centre, Length outerDiameter)
{
    const SweptLine line = sweptLine(p_E_centre);
    const Vec3 p_E_tip = line.points.back();
    const Vec3 p_A_tip = tube.X_AE * tube.p_E_tip;
    const Quat q_AE = tube.X_AE.rotation()
                      * Quat::FromTwoVectors(p_E_tip - line.points.front(),
                                             tube.p_E_tip - tube.p_E_centre.front());
    return {.X_AE = {q_AE, p_A_tip - q_AE * p_E_tip},
            .p_E_centre = line.points,
            .p_E_tip = p_E_tip,
            .tipAboveCarina = tube.tipAboveCarina,
            .innerDiameter = soldInnerDiameterOf(outerDiameter),
            .outerDiameter = outerDiameter,
            .pieces = piecesOf(line, 0.5 * outerDiameter.si),
            .fitsAirway = false};
}

TubeShape bent(TubeShape tube, const NeckField& neck)
{
    if (!tube.fitsAirway || !neck.isBent())
        return tube;
    const RigidTransform X_AE = tube.X_AE;
    for (Vec3& p_E : tube.p_E_centre)
        p_E = bentInBody(neck, X_AE, p_E);
    tube.p_E_tip = bentInBody(neck, X_AE, tube.p_E_tip);
    for (TubePiece& piece : tube.pieces)
        piece.mesh =
            takenTo(deformed(takenTo(std::move(piece.mesh), X_AE), neck), outOfNeck(neck, X_AE));
    tube.X_AE = neck.X_AU() * X_AE;
    return tube;
}

std::vector<Vec3> centreIn(const NeckField& neck, const TubeShape& tube)
{
    if (!tube.fitsAirway || !neck.isBent())
        return tube.p_E_centre;
    std::vector<Vec3> p_E_bent;
    p_E_bent.reserve(tube.p_E_centre.size());
    for (const Vec3& p_E : tube.p_E_centre)
        p_E_bent.push_back(bentInBody(neck, tube.X_AE, p_E));
    return withLength(std::move(p_E_bent), lengthOf(tube.p_E_centre).si);
}

Length tipFromPlace(const TubeShape& tube, const NeckField& neck, const RigidTransform& X_AE)
{
    const Vec3 p_E_tip = tube.fitsAirway ? bentInBody(neck, tube.X_AE, tube.p_E_tip) : tube.p_E_tip;
    return metres((X_AE * p_E_tip - neck.placed(tube.X_AE * tube.p_E_tip)).norm());
}

} // namespace carina
