#include "engine/airway/lumen/wall_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

namespace carina
{
namespace
{

// Of the choice of points; of ours, as all that follow.
constexpr double kFacing = -0.3;  ///< cosine between a normal and the way to the trunk, at least
constexpr double kBall = 1.5e-3;  ///< metres: a ball of this radius has to fit before a point
constexpr double kOfBall = 0.8;   ///< of the ball: so near to its middle another wall may come
constexpr double kFarther = 2e-3; ///< metres: so far a point may lie behind the sections' walls

constexpr std::size_t kPieces = 2;
constexpr double kSlab = 1e-3;        ///< metres on either side of a section for which it stands
constexpr std::size_t kAround = 3;    ///< sections as measured, before and behind the nearest
constexpr double kLeastSide = 0.4e-3; ///< metres from the middle of a section that is too narrow
constexpr double kMiddle = 1e-3;      ///< metres: what is narrower keeps its middle
constexpr int kMiddleRounds = 8;
constexpr int kNeighbourRounds = 4;
constexpr double kToNeighbours = 0.9;
constexpr double kMostOfSide = 0.5; ///< that a middle goes in one round

constexpr auto kOpposite = std::size_t(kLumenDirections / 2);

/// Edge of the cubes, metres; nothing for tissue without points.
std::optional<double> apartIn(AirwayTissue tissue)
{
    switch (tissue) {
    case AirwayTissue::Teeth:
    case AirwayTissue::Skin:
        return 2e-3;
    case AirwayTissue::Larynx:
        return 3e-3;
    case AirwayTissue::Throat:
    case AirwayTissue::Pharynx:
        return 4e-3;
    case AirwayTissue::Windpipe:
        break;
    }
    return std::nullopt;
}

double farthestWall(const LumenSection& section)
{
    double most = 0.0;
    for (const LumenLimit& limit : section.limits)
        most = std::max(most, (limit.p_A_wall - section.p_A_centre).norm());
    return most;
}

/// A point that may stand for its cube.
struct WallCandidate {
    WallPoint point;
    Vec3 normal = Vec3::Zero();
    double distance = 0.0; ///< from the trunk's middle
};
using WallCube = std::array<int, 4>; ///< and its tissue

WallCube cubeOf(const Vec3& p_A, AirwayTissue tissue, double apart)
{
    const Vec3 at = p_A / apart;
    return {int(std::floor(at.x())), int(std::floor(at.y())), int(std::floor(at.z())), int(tissue)};
}

const std::array<std::array<double, 2>, kLumenDirections>& sideDirections()
{
    static const auto directions = [] {
        std::array<std::array<double, 2>, kLumenDirections> made{};
        const AcrossWay plane{Vec3::UnitZ(), Vec3::UnitX(), Vec3::UnitY()};
        for (std::size_t k = 0; k < kLumenDirections; ++k)
            made[k] = {plane.direction(k).x(), plane.direction(k).y()};
        return made;
    }();
    return directions;
}

double alongSide(std::size_t k, double u, double v)
{
    return sideDirections()[k][0] * u + sideDirections()[k][1] * v;
}

/// A section with what is needed for each point.
struct CutSection {
    MovedSection* section;
    Vec3 normal = Vec3::Zero();
    double farthest = 0.0; ///< of its sides

    /// How far the place is behind its plane.
    [[nodiscard]] double behind(const Vec3& p_A) const
    {
        return (p_A - section->p_A_centre).dot(normal);
    }
};

/// Takes away what is nearer than a radius to a place, within the slab.
void cutOff(const CutSection& it, const Vec3& p_A, double behind, double radius)
{
    MovedSection& section = *it.section;
    const double beside = std::max(std::abs(behind) - kSlab, 0.0);
    const double disc = std::sqrt(radius * radius - beside * beside);
    const Vec3 from = p_A - section.p_A_centre;
    const double u = from.dot(section.side);
    const double v = from.dot(section.back);
    if (u * u + v * v > (it.farthest + disc) * (it.farthest + disc))
        return;
    std::size_t towards = 0;
    double most = 0.0;
    for (std::size_t k = 0; k < kOpposite; ++k)
        if (const double there = alongSide(k, u, v); std::abs(there) > most) {
            most = std::abs(there);
            towards = there > 0.0 ? k : k + kOpposite;
        }
    section.reach[towards] = std::min(section.reach[towards], most - disc);
}

/// Of all sections near a place, between two of them.
void cutOff(std::span<const CutSection> sections, std::size_t about, const Vec3& p_A, double radius)
{
    const std::size_t around = kPieces * kAround;
    const std::size_t first = about > around ? about - around : 0;
    const std::size_t last = std::min(about + around + 1, sections.size());
    for (std::size_t i = first; i < last; ++i) {
        const double behind = sections[i].behind(p_A);
        if (std::abs(behind) < radius + kSlab)
            cutOff(sections[i], p_A, behind, radius);
    }
}

void shiftMiddle(MovedSection& section, double u, double v)
{
    section.p_A_centre += u * section.side + v * section.back;
    for (std::size_t k = 0; k < kLumenDirections; ++k)
        section.reach[k] -= alongSide(k, u, v);
}

/// Measures how narrow it has become, and goes away from sides that are too near.
void toMiddle(MovedSection& section)
{
    for (std::size_t k = 0; k < kOpposite; ++k)
        section.spare =
            std::min(section.spare, 0.5 * (section.reach[k] + section.reach[k + kOpposite]));
    for (int round = 0; round < kMiddleRounds; ++round) {
        const auto nearest = std::ranges::min_element(section.reach);
        const auto k = std::size_t(nearest - section.reach.begin());
        const double more = section.reach[(k + kOpposite) % kLumenDirections] - *nearest;
        if (*nearest >= kLeastSide || !(more > 0.0))
            return;
        const double way = std::min(0.5 * more, kMiddle - *nearest);
        shiftMiddle(section, -way * sideDirections()[k][0], -way * sideDirections()[k][1]);
    }
}

/// Towards the middle between its neighbours, no farther than a share of the way to a side.
void toNeighbours(MovedSection& section, const Vec3& p_A_before, const Vec3& p_A_after)
{
    if (section.spare < kMiddle)
        return;
    const Vec3 towards = kToNeighbours * (0.5 * (p_A_before + p_A_after) - section.p_A_centre);
    const double u = towards.dot(section.side);
    const double v = towards.dot(section.back);
    double share = kMostOfSide;
    for (std::size_t k = 0; k < kLumenDirections; ++k)
        share = std::max(share, alongSide(k, u, v)
                                    / std::max(section.reach[k], MovedSection::kLeastReach));
    shiftMiddle(section, kMostOfSide / share * u, kMostOfSide / share * v);
}

std::vector<MovedSection> divided(const std::vector<MovedSection>& sections)
{
    std::vector<MovedSection> fine;
    fine.reserve(kPieces * sections.size());
    for (std::size_t i = 0; i + 1 < sections.size(); ++i)
        for (std::size_t piece = 0; piece < kPieces; ++piece)
            fine.push_back(between(sections[i], sections[i + 1], double(piece) / double(kPieces)));
    fine.push_back(sections.back());
    return fine;
}

void makeEven(MovedWay& way)
{
    std::vector<MovedSection>& sections = way.sections;
    for (MovedSection& section : sections)
        toMiddle(section);
    for (int round = 0; round < kNeighbourRounds; ++round)
        for (std::size_t i = 1; i + 1 < sections.size(); ++i)
            toNeighbours(sections[i], sections[i - 1].p_A_centre, sections[i + 1].p_A_centre);
    for (MovedSection& section : sections)
        for (double& side : section.reach)
            side = std::max(side, kLeastSide);
    way.along.assign(sections.size(), 0.0);
    for (std::size_t i = 1; i < sections.size(); ++i)
        way.along[i] =
            way.along[i - 1] + (sections[i].p_A_centre - sections[i - 1].p_A_centre).norm();
}

} // namespace

std::vector<WallPoint> wallPoints(std::span<const AnatomyPart> parts,
                                  std::span<const LumenSection> trunk, std::size_t first,
                                  std::size_t last, const WallSurfaces& walls)
{
    std::map<WallCube, WallCandidate> cubes;
    for (const AnatomyPart& part : parts) {
        const AirwayTissue tissue = tissueOfWall(part);
        const auto apart = apartIn(tissue);
        if (!isAirwayWall(part.role) || !apart)
            continue;
        TriangleMesh mesh = part.levels.front();
        computeNormals(mesh);
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            const Vec3 p_A = mesh.positions[i].cast<double>();
            const auto nearest = std::ranges::min_element(trunk, {}, [&](const LumenSection& it) {
                return (it.p_A_centre - p_A).squaredNorm();
            });
            const auto section = std::size_t(nearest - trunk.begin());
            const Vec3 towards = nearest->p_A_centre - p_A;
            const double distance = towards.norm();
            const Vec3 normal = mesh.normals[i].cast<double>();
            if (section < first || section >= last || distance > farthestWall(*nearest) + kFarther
                || normal.dot(towards) < kFacing * distance)
                continue;
            const auto [it, isNew] = cubes.try_emplace(cubeOf(p_A, tissue, *apart));
            if (isNew || distance < it->second.distance)
                it->second = {{p_A, tissue, section}, normal, distance};
        }
    }
    std::vector<WallPoint> points;
    for (const auto& [cube, candidate] : cubes)
        if (walls.distanceTo(candidate.point.p_A + kBall * candidate.normal) > kOfBall * kBall)
            points.push_back(candidate.point);
    return points;
}

std::size_t keepOff(MovedWay& trunk, const AirwayLumen& lumen, const TissueMotion& motion,
                    const TissueMotion& push)
{
    if (lumen.points.empty())
        return 1;
    trunk.sections = divided(trunk.sections);
    std::vector<CutSection> cuts;
    cuts.reserve(trunk.sections.size());
    for (MovedSection& section : trunk.sections) {
        section.side.normalize();
        section.back.normalize();
        cuts.push_back(
            {&section, section.back.cross(section.side), std::ranges::max(section.reach)});
    }
    for (const WallPoint& point : lumen.points) {
        const Vec3 p_A = motion(point.p_A, point.tissue);
        cutOff(cuts, kPieces * point.section, push ? push(p_A, point.tissue) : p_A,
               lumen.tubeRadius.si);
    }
    makeEven(trunk);
    return kPieces;
}

} // namespace carina
