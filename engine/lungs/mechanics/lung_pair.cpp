#include "engine/lungs/mechanics/lung_pair.h"

#include "engine/core/expects.h"
#include "engine/geometry/mesh/mesh_winding.h"

#include <algorithm>
#include <cmath>
#include <tbb/parallel_for.h>

namespace carina
{
namespace
{

using Lung = std::vector<const AnatomyPart*>;

constexpr std::array kSides{Side::Right, Side::Left};

/// The vertex of a lung nearest to the carina, the origin of A.
Vec3 nearestToCarina(const Lung& lung)
{
    Vec3f nearest = lung.front()->levels.front().positions.front();
    for (const AnatomyPart* part : lung) {
        for (const Vec3f& p_A : part->levels.front().positions) {
            if (p_A.squaredNorm() < nearest.squaredNorm())
                nearest = p_A;
        }
    }
    return nearest.cast<double>();
}

Box boxOf(const Lung& lung)
{
    Box box_A;
    for (const AnatomyPart* part : lung)
        box_A.include(boundsOf(part->levels.front()));
    return box_A;
}

Vec3 mirrored(const Vec3& p_A) { return {-p_A.x(), p_A.y(), p_A.z()}; }

ChestField fieldOf(const Lung& right, const Lung& left)
{
    if (right.empty() && left.empty())
        return {};
    Box box_A;
    for (const Lung* lung : {&right, &left}) {
        if (!lung->empty())
            box_A.include(boxOf(*lung));
    }
    const Vec3 p_A_right = nearestToCarina(right.empty() ? left : right);
    const Vec3 p_A_left = nearestToCarina(left.empty() ? right : left);
    if (!right.empty() && !left.empty())
        return {box_A, p_A_right, p_A_left};
    Box both_A = box_A;
    both_A.include(mirrored(box_A.min));
    both_A.include(mirrored(box_A.max));
    return right.empty() ? ChestField{both_A, mirrored(p_A_left), p_A_left}
                         : ChestField{both_A, p_A_right, mirrored(p_A_right)};
}

Lung partsOf(const Anatomy& anatomy, Side side)
{
    Lung lung;
    for (const AnatomyPart& part : anatomy.parts) {
        if (lungSide(part.role) == side)
            lung.push_back(&part);
    }
    return lung;
}

Result<void> checkClosed(const AnatomyPart& part)
{
    const auto encloses = [](const TriangleMesh& level) {
        return isClosed(level) && signedVolume(level) > 0.0;
    };
    if (part.levels.empty() || !std::ranges::all_of(part.levels, encloses))
        return fail(Errc::MeshNotClosed, part.name);
    return {};
}

/// The pose in which one number of a lung's is 1: the modes of its volume tensor, in their order.
constexpr VolumeTensor::Amplitudes modesOf(const LungPose& lung, double shift)
{
    return {lung.diaphragm, lung.ribs, lung.gravity, lung.collapse, shift};
}

ChestPose poseOfMode(std::size_t mode)
{
    ChestPose pose;
    const auto unit = [mode](std::size_t k) { return mode == k ? 1.0 : 0.0; };
    pose.lungs.fill({unit(0), unit(1), unit(2), unit(3)});
    pose.mediastinalShift = unit(4);
    return pose;
}

VolumeTensor::Fields fieldsOf(const TriangleMesh& mesh, ChestRegion region, const ChestField& field)
{
    VolumeTensor::Fields fields;
    for (std::size_t mode = 0; mode < VolumeTensor::kModes; ++mode) {
        const ChestMotion motion = motionOf(region, poseOfMode(mode), field);
        for (const Vec3f& p_A : mesh.positions)
            fields[mode].push_back(field.at(p_A.cast<double>(), motion).d_A);
    }
    return fields;
}

} // namespace

Result<LungPair> LungPair::of(const Anatomy& anatomy)
{
    LungPair pair;
    const std::array lungs{partsOf(anatomy, Side::Right), partsOf(anatomy, Side::Left)};
    for (const Side side : kSides) {
        for (const AnatomyPart* part : lungs[indexOf(side)]) {
            if (const Result<void> closed = checkClosed(*part); !closed)
                return tl::unexpected(closed.error());
            pair.m_parts.push_back({static_cast<std::size_t>(part - anatomy.parts.data()), side,
                                    regionOf(part->role), part->levels});
        }
    }
    pair.m_field = fieldOf(lungs[0], lungs[1]);
    pair.sumVolumes();
    return pair;
}

void LungPair::sumVolumes()
{
    std::size_t levels = 0;
    for (const BreathingPart& part : m_parts)
        levels = std::max(levels, part.levels.size());
    m_volumes.resize(levels);
    tbb::parallel_for(std::size_t{0}, levels * kSides.size(), [this](std::size_t i) {
        const std::size_t level = i / kSides.size();
        const Side side = kSides[i % kSides.size()];
        for (const BreathingPart& part : m_parts) {
            if (part.side != side)
                continue;
            const TriangleMesh& mesh = levelOf(part, level);
            m_volumes[level][indexOf(side)].add(mesh, fieldsOf(mesh, part.region, m_field));
        }
    });
}

Volume LungPair::restVolume(Side side) const
{
    return m_volumes.empty() ? Volume{} : m_volumes.front()[indexOf(side)].along({}, {}).at(0.0);
}

Volume LungPair::volumeWith(Volume inspired, Side side) const
{
    const Volume both = restVolume(Side::Right) + restVolume(Side::Left);
    if (both.si == 0.0)
        return both;
    const Volume rest = restVolume(side);
    return rest + (rest / both) * inspired;
}

VolumeCubic LungPair::volumeAlong(Side side, std::size_t level, const LungPose& given,
                                  const LungPose& along, double mediastinalShift) const
{
    CARINA_EXPECTS(level < m_volumes.size());
    return m_volumes[level][indexOf(side)].along(modesOf(given, mediastinalShift),
                                                 modesOf(along, 0.0));
}

Result<ChestPose> LungPair::pose(const std::array<LungDemand, 2>& demands, double mediastinalShift,
                                 std::size_t level) const
{
    if (m_volumes.empty())
        return ChestPose{};
    CARINA_EXPECTS(level < m_volumes.size());
    ChestPose pose;
    pose.mediastinalShift = mediastinalShift;
    for (const Side side : kSides) {
        if (restVolume(side).si == 0.0)
            continue;
        const auto& [volume, given, along, nearest] = demands[indexOf(side)];
        const double shiftInto = side == Side::Left ? mediastinalShift : -mediastinalShift;
        const auto range = amplitudesWithin(given, along, shiftInto);
        if (!range)
            return fail(Errc::VolumeUnreachable, "a lung cannot be deformed as asked");
        const VolumeCubic cubic = volumeAlong(side, level, given, along, mediastinalShift);
        const Result<double> s = amplitudeFor(cubic, volume, nearest, *range);
        if (!s)
            return tl::unexpected(s.error());
        pose.lungs[indexOf(side)] = given + *s * along;
    }
    return pose;
}

Result<ChestPose> LungPair::pose(Volume inspired, std::size_t level) const
{
    constexpr LungPose kRibs{.ribs = 1.0};
    const LungPose deepest =
        amplitudesWithin({}, kQuietBreath, 0.0).value().greatest * kQuietBreath;
    std::array<LungDemand, 2> demands;
    for (const Side side : kSides) {
        LungDemand& demand = demands[indexOf(side)];
        demand.volume = volumeWith(inspired, side);
        if (!m_volumes.empty()
            && volumeAlong(side, level, deepest, kRibs, 0.0).at(0.0) < demand.volume)
            demand = {demand.volume, deepest, kRibs};
    }
    return pose(demands, 0.0, level);
}

const TriangleMesh& levelOf(const BreathingPart& part, std::size_t level)
{
    return part.levels[std::min(level, part.levels.size() - 1)];
}

} // namespace carina
