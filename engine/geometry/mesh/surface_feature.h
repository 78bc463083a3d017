#pragma once

#include "engine/core/units.h"
#include "engine/geometry/mesh/triangle_mesh.h"

#include <optional>

namespace carina
{

/// How a surface is curved at a place, per metre: 1 / r on a ball of radius r, negative in a
/// hollow.
struct Curvature {
    double least = 0.0; ///< of all directions along the surface
    double most = 0.0;
    Vec3 dir_most = Vec3::Zero(); ///< unit, in which it is curved most
};

/// Places that a finger finds.
enum class SurfaceFeature : std::uint8_t {
    Tip,   ///< curved outwards in all directions: its least curvature is greatest there
    Ridge, ///< curved outwards across: its greatest curvature is, compared with both sides
};

struct FeaturePoint {
    std::uint32_t vertex = 0;
    Vec3 p = Vec3::Zero();
    Curvature curvature{};
};

struct FeatureSettings {
    Length radius = millimetres(10.0); ///< how far from the place picked a feature may lie
    Length scale = millimetres(3.0);   ///< of what is seen: finer bumps are smoothed over
};

/// Principal curvatures at a vertex: the least squares fit of
///
///     w = f + d u + e v + (a u^2 + 2 b u v + c v^2) / 2
///
/// to the vertices that edges reach within `scale`, w along the vertex's normal (Goldfeather and
/// Interrante 2004): the eigenvalues of its quadratic part.
/// @returns nothing where these vertices do not tell all six terms.
/// @pre the mesh's vertices are welded; the vertex is one of it.
[[nodiscard]] std::optional<Curvature> curvatureAt(const TriangleMesh& mesh, std::uint32_t vertex,
                                                   Length scale);

/// The vertex of extreme curvature nearest to a place that was picked. A vertex is extreme where no
/// other within `scale` of it is curved more, for a ridge no other to its sides. Features fainter
/// than half of the strongest within the radius are passed over, and so is what bends by less than
/// a tenth of a radian over the scale. Of two as near the first of the mesh is taken.
/// @returns nothing where there is none within the radius.
/// @pre the mesh's vertices are welded.
[[nodiscard]] std::optional<FeaturePoint> nearestFeature(const TriangleMesh& mesh, const Vec3& p,
                                                         SurfaceFeature feature,
                                                         const FeatureSettings& settings = {});

} // namespace carina
