#include "widgets/scene/surfaces/merged_surface.h"

#include "engine/core/expects.h"

#include <algorithm>
#include <map>

namespace carina
{

namespace
{

Vec3f asFloats(const Rgb& color)
{
    constexpr float kBrightest = 255.0F;
    return Vec3f(color[0], color[1], color[2]) / kBrightest;
}

void appendMesh(MergedSurface& surface, const ScenePart& part, std::size_t level)
{
    const TriangleMesh& mesh = *part.levels[level];
    CARINA_EXPECTS(mesh.normals.size() == mesh.positions.size());
    const std::span<const Rgb> own =
        part.colors.empty() ? std::span<const Rgb>{} : std::span{part.colors[level]};
    CARINA_EXPECTS(own.empty() || own.size() == mesh.positions.size());
    const auto first = static_cast<std::uint32_t>(surface.vertices.size());
    const Vec3f color{part.color.redF(), part.color.greenF(), part.color.blueF()};
    const Vec3f which{static_cast<float>(part.id), static_cast<float>(part.region),
                      static_cast<float>(part.group)};
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        surface.vertices.push_back(
            {mesh.positions[i], mesh.normals[i], own.empty() ? color : asFloats(own[i]), which});
    for (const Triangle& t : mesh.triangles)
        surface.triangles.push_back({first + t[0], first + t[1], first + t[2]});
}

void appendPart(MergedSurface& surface, const ScenePart& part, std::size_t place)
{
    for (std::size_t level = 0; level < part.levels.size(); ++level) {
        const TriangleMesh& mesh = *part.levels[level];
        surface.pieces.push_back({place, static_cast<int>(level), surface.triangles.size(),
                                  mesh.triangles.size(), part.group == MaterialGroup::Airway,
                                  part.liftedWith});
        appendMesh(surface, part, level);
    }
}

/// Makes room for all of it at once: growing would copy it several times over.
void reserveFor(std::map<SurfaceKey, MergedSurface>& merged, std::span<const ScenePart> parts)
{
    struct Size {
        std::size_t vertices = 0;
        std::size_t triangles = 0;
    };
    std::map<SurfaceKey, Size> sizes;
    for (const ScenePart& part : parts)
        for (const auto& level : part.levels) {
            Size& size = sizes[surfaceKey(part)];
            size.vertices += level->positions.size();
            size.triangles += level->triangles.size();
        }
    for (const auto& [key, size] : sizes) {
        merged[key].key = key;
        merged[key].vertices.reserve(size.vertices);
        merged[key].triangles.reserve(size.triangles);
    }
}

} // namespace

SurfaceKey surfaceKey(const ScenePart& part)
{
    const DrawLayer layer = drawLayerOf(part.group);
    if (layer == DrawLayer::Blended)
        return {layer, part.body, std::nullopt};
    return {layer, part.body, part.region};
}

std::vector<MergedSurface> mergedSurfaces(std::span<const ScenePart> parts)
{
    std::map<SurfaceKey, MergedSurface> merged;
    reserveFor(merged, parts);
    for (std::size_t place = 0; place < parts.size(); ++place) {
        const ScenePart& part = parts[place];
        CARINA_EXPECTS(!part.levels.empty());
        appendPart(merged[surfaceKey(part)], part, place);
    }
    std::vector<MergedSurface> surfaces;
    for (auto& [key, surface] : merged)
        surfaces.push_back(std::move(surface));
    return surfaces;
}

std::vector<Triangle> trianglesAt(std::span<const int> levels, std::span<const SurfacePiece> pieces,
                                  std::span<const Triangle> triangles, bool bothFaces)
{
    std::vector<Triangle> chosen;
    for (const SurfacePiece& piece : pieces) {
        if (levels[piece.part] != piece.level)
            continue;
        for (const Triangle& t : triangles.subspan(piece.firstTriangle, piece.triangles)) {
            chosen.push_back(t);
            if (bothFaces || piece.seenInto)
                chosen.push_back({t[0], t[2], t[1]});
        }
    }
    return chosen;
}

} // namespace carina
