#pragma once

#include "widgets/scene/surfaces/scene_part.h"

#include "engine/geometry/mesh/triangle_mesh.h"

#include <compare>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace carina
{

/// What can be drawn in one go.
struct SurfaceKey {
    DrawLayer layer = DrawLayer::Closed;
    std::string body;
    /// How all of it breathes; nothing where that differs from corner to corner, as it does in what
    /// is blended in one order.
    std::optional<ChestRegion> region;

    friend auto operator<=>(const SurfaceKey&, const SurfaceKey&) = default;
};

/// A corner of a surface as resources/shaders/organ.vert reads it.
struct SurfaceVertex {
    Vec3f position;
    Vec3f normal;
    Vec3f color; ///< sRGB, 0 to 1
    Vec3f part;  ///< id, ChestRegion, MaterialGroup
};

/// One part in one level of detail.
struct SurfacePiece {
    std::size_t part = 0; ///< its place among the parts of the scene
    int level = 0;
    std::size_t firstTriangle = 0;
    std::size_t triangles = 0;
    bool seenInto = false; ///< its inner face is drawn, too, whoever draws front faces only
};

/// Several parts, in all their levels of detail, in one pair of buffers.
struct MergedSurface {
    SurfaceKey key;
    std::vector<SurfaceVertex> vertices;
    std::vector<Triangle> triangles; ///< of all pieces, one after the other
    std::vector<SurfacePiece> pieces;
};

[[nodiscard]] SurfaceKey surfaceKey(const ScenePart& part);

/// How many levels of detail the scene has: those of the part that has most, at least one.
[[nodiscard]] int levelCount(std::span<const ScenePart> parts);

/// The parts, merged by layer and body, what is opaque also by region.
///
/// @pre each part has a level; each mesh has normals, and colours as ScenePart says.
[[nodiscard]] std::vector<MergedSurface> mergedSurfaces(std::span<const ScenePart> parts);

/// The triangles of the pieces whose parts are drawn in these levels of detail, by place among the
/// parts of the scene; where one sees into a piece, or `bothFaces` is asked for, each of them is
/// followed by the same one turned over.
[[nodiscard]] std::vector<Triangle> trianglesAt(std::span<const int> levels,
                                                std::span<const SurfacePiece> pieces,
                                                std::span<const Triangle> triangles,
                                                bool bothFaces = false);

} // namespace carina
