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

/// Surfaces with equal keys can be drawn by one draw call.
struct SurfaceKey {
    DrawLayer layer = DrawLayer::Closed;
    std::string body;
    /// The region of the whole surface; std::nullopt if it varies by vertex, as in blended
    /// surfaces, which are sorted together.
    std::optional<ChestRegion> region;

    friend auto operator<=>(const SurfaceKey&, const SurfaceKey&) = default;
};

/// A vertex with the attributes of resources/shaders/organ.vert.
struct SurfaceVertex {
    Vec3f position;
    Vec3f normal;
    Vec3f color; ///< sRGB, 0 to 1
    Vec3f part;  ///< id, ChestRegion, MaterialGroup
};

/// One part in one level of detail.
struct SurfacePiece {
    std::size_t part = 0; ///< its index among the parts of the scene
    int level = 0;
    std::size_t firstTriangle = 0;
    std::size_t triangles = 0;
    bool seenInto = false;    ///< its inner face is drawn, too, even if only front faces are drawn
    std::string liftedWith{}; ///< as of the part
};

/// Several parts, in all their levels of detail, in one pair of buffers.
struct MergedSurface {
    SurfaceKey key;
    std::vector<SurfaceVertex> vertices;
    std::vector<Triangle> triangles; ///< of all pieces in sequence
    std::vector<SurfacePiece> pieces;
};

[[nodiscard]] SurfaceKey surfaceKey(const ScenePart& part);

/// Merges the parts by layer and body, opaque ones also by region.
///
/// @pre each part has a level; each mesh has normals, and colours as ScenePart requires.
[[nodiscard]] std::vector<MergedSurface> mergedSurfaces(std::span<const ScenePart> parts);

/// The triangles of the pieces whose level is that in `levels`, which is indexed by part. For
/// pieces with `seenInto`, or for all if `bothFaces`, each triangle is followed by its reverse.
[[nodiscard]] std::vector<Triangle> trianglesAt(std::span<const int> levels,
                                                std::span<const SurfacePiece> pieces,
                                                std::span<const Triangle> triangles,
                                                bool bothFaces = false);

} // namespace carina
