#pragma once

#include "widgets/scene/scene_part.h"

#include "engine/geometry/triangle_mesh.h"

#include <compare>
#include <span>
#include <string>
#include <vector>

namespace carina
{

/// What can be drawn in one go: equal material, region, body and levels of detail.
struct SurfaceKey {
    MaterialGroup group = MaterialGroup::Bone;
    ChestRegion region = ChestRegion::Still;
    std::string body;
    int firstLevel = 0; ///< drawn in the levels of detail firstLevel ..
    int lastLevel = 0;  ///< .. to lastLevel, both included

    friend auto operator<=>(const SurfaceKey&, const SurfaceKey&) = default;
};

/// A corner of a surface as resources/shaders/organ.vert reads it.
struct SurfaceVertex {
    Vec3f position;
    Vec3f normal;
    Vec3f color; ///< sRGB, 0 to 1
    float partId;
};

/// Several parts in one pair of buffers: one draw.
struct MergedSurface {
    SurfaceKey key;
    std::vector<SurfaceVertex> vertices;
    std::vector<Triangle> triangles;
};

/// How many levels of detail the scene has: those of the part that has most, at least one.
[[nodiscard]] int levelCount(std::span<const ScenePart> parts);

/// The parts, merged. A part with fewer levels of detail than the scene is drawn in its coarsest in
/// all further ones, and is stored once for them.
///
/// @pre each part has a level; each mesh has normals.
[[nodiscard]] std::vector<MergedSurface> mergedSurfaces(std::span<const ScenePart> parts);

/// Triangles that are drawn in each level of detail.
[[nodiscard]] std::vector<std::size_t> trianglesPerLevel(std::span<const ScenePart> parts);

} // namespace carina
