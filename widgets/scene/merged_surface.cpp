#include "widgets/scene/merged_surface.h"

#include "engine/core/expects.h"

#include <algorithm>
#include <map>

namespace carina
{

namespace
{

void appendPart(MergedSurface& surface, const ScenePart& part, const TriangleMesh& mesh)
{
    CARINA_EXPECTS(mesh.normals.size() == mesh.positions.size());
    const auto first = static_cast<std::uint32_t>(surface.vertices.size());
    const Vec3f color{part.color.redF(), part.color.greenF(), part.color.blueF()};
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        surface.vertices.push_back(
            {mesh.positions[i], mesh.normals[i], color, static_cast<float>(part.id)});
    for (const Triangle& t : mesh.triangles)
        surface.triangles.push_back({first + t[0], first + t[1], first + t[2]});
}

} // namespace

int levelCount(std::span<const ScenePart> parts)
{
    std::size_t count = 1;
    for (const ScenePart& part : parts)
        count = std::max(count, part.levels.size());
    return static_cast<int>(count);
}

std::vector<MergedSurface> mergedSurfaces(std::span<const ScenePart> parts)
{
    const int levels = levelCount(parts);
    std::map<SurfaceKey, MergedSurface> merged;
    for (const ScenePart& part : parts) {
        CARINA_EXPECTS(!part.levels.empty());
        const int own = static_cast<int>(part.levels.size());
        for (int level = 0; level < own; ++level) {
            const int last = level + 1 == own ? levels - 1 : level;
            const SurfaceKey key{part.group, part.region, part.body, level, last};
            MergedSurface& surface = merged[key];
            surface.key = key;
            appendPart(surface, part, *part.levels[static_cast<std::size_t>(level)]);
        }
    }
    std::vector<MergedSurface> surfaces;
    for (auto& [key, surface] : merged)
        surfaces.push_back(std::move(surface));
    return surfaces;
}

std::vector<std::size_t> trianglesPerLevel(std::span<const ScenePart> parts)
{
    std::vector<std::size_t> counts(static_cast<std::size_t>(levelCount(parts)), 0);
    for (std::size_t level = 0; level < counts.size(); ++level)
        for (const ScenePart& part : parts)
            counts[level] += part.levels[std::min(level, part.levels.size() - 1)]->triangles.size();
    return counts;
}

} // namespace carina
