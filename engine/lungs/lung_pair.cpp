#include "engine/lungs/lung_pair.h"

#include "engine/core/expects.h"
#include "engine/geometry/mesh_winding.h"
#include "engine/lungs/displacement_mode.h"

#include <algorithm>

namespace carina
{
namespace
{

std::size_t indexOf(Side side) { return side == Side::Right ? 0 : 1; }

/// The vertex of a lung nearest to the carina, the origin of A.
Vec3 nearestToCarina(const std::vector<const AnatomyPart*>& lung)
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

DisplacementMode modeOf(const std::vector<const AnatomyPart*>& lung, Side side)
{
    Box box_A;
    for (const AnatomyPart* part : lung)
        box_A.include(boundsOf(part->levels.front()));
    return {box_A, side, nearestToCarina(lung)};
}

std::vector<const AnatomyPart*> partsOf(const Anatomy& anatomy, Side side)
{
    std::vector<const AnatomyPart*> lung;
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

} // namespace

Result<LungPair> LungPair::of(const Anatomy& anatomy)
{
    LungPair pair;
    for (const Side side : {Side::Right, Side::Left}) {
        const std::vector<const AnatomyPart*> lung = partsOf(anatomy, side);
        for (const AnatomyPart* part : lung) {
            if (const Result<void> closed = checkClosed(*part); !closed)
                return tl::unexpected(closed.error());
        }
        if (lung.empty())
            continue;
        const DisplacementMode mode = modeOf(lung, side);
        for (const AnatomyPart* part : lung) {
            BreathingPart& breathing = pair.m_parts.emplace_back();
            breathing.index = static_cast<std::size_t>(part - anatomy.parts.data());
            breathing.side = side;
            for (const TriangleMesh& level : part->levels)
                breathing.levels.push_back(makeDeformable(level, mode));
        }
    }
    pair.sumVolumes();
    return pair;
}

void LungPair::sumVolumes()
{
    std::size_t levels = 0;
    for (const BreathingPart& part : m_parts)
        levels = std::max(levels, part.levels.size());
    m_cubics.resize(levels);
    for (const BreathingPart& part : m_parts) {
        for (std::size_t level = 0; level < levels; ++level)
            m_cubics[level][indexOf(part.side)] += volumeCubic(levelOf(part, level));
    }
}

Volume LungPair::restVolume(Side side) const
{
    return m_cubics.empty() ? Volume{} : m_cubics.front()[indexOf(side)].at(0.0);
}

Volume LungPair::volumeWith(Volume inspired, Side side) const
{
    const Volume both = restVolume(Side::Right) + restVolume(Side::Left);
    if (both.si == 0.0)
        return both;
    const Volume rest = restVolume(side);
    return rest + (rest / both) * inspired;
}

Result<LungAmplitudes> LungPair::amplitudes(Volume inspired, std::size_t level) const
{
    if (m_cubics.empty())
        return LungAmplitudes{};
    CARINA_EXPECTS(level < m_cubics.size());
    std::array<float, 2> amplitude{};
    for (const Side side : {Side::Right, Side::Left}) {
        const VolumeCubic& cubic = m_cubics[level][indexOf(side)];
        if (cubic.at(0.0).si == 0.0)
            continue;
        const Result<double> s = amplitudeFor(cubic, volumeWith(inspired, side), 0.0);
        if (!s)
            return tl::unexpected(s.error());
        amplitude[indexOf(side)] = static_cast<float>(*s);
    }
    return LungAmplitudes{amplitude[0], amplitude[1]};
}

Box LungPair::bounds(Side side) const
{
    // Vertices move along straight lines, so the ends of the range bound all of it.
    Box box_A;
    for (const BreathingPart& part : m_parts) {
        if (part.side != side)
            continue;
        for (const DeformableMesh& mesh : part.levels) {
            for (std::size_t i = 0; i < mesh.rest.positions.size(); ++i) {
                const Vec3 x0 = mesh.rest.positions[i].cast<double>();
                const Vec3 d = mesh.displacement[i].cast<double>();
                box_A.include(Vec3{x0 + kLeastAmplitude * d});
                box_A.include(Vec3{x0 + kGreatestAmplitude * d});
            }
        }
    }
    return box_A;
}

const DeformableMesh& levelOf(const BreathingPart& part, std::size_t level)
{
    return part.levels[std::min(level, part.levels.size() - 1)];
}

} // namespace carina
