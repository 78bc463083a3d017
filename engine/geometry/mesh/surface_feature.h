#pragma once

#include "engine/core/units.h"
#include "engine/geometry/mesh/triangle_mesh.h"

#include <optional>
#include <span>

namespace carina
{

/// The principal curvatures of a surface at a point, per metre: 1 / r on a ball of radius r,
/// negative where the surface is concave.
struct Curvature {
    double least = 0.0;           ///< the smaller principal curvature
    double most = 0.0;            ///< the larger principal curvature
    Vec3 dir_most = Vec3::Zero(); ///< unit direction of the larger
};

/// Kinds of places that a finger can find on a bone.
enum class SurfaceFeature : std::uint8_t {
    Tip,   ///< a local maximum of the least curvature: convex in all directions
    Ridge, ///< a local maximum of the largest curvature, compared across the ridge
};

/// A feature found on a mesh; position in the mesh's frame, metres.
struct FeaturePoint {
    std::uint32_t vertex = 0;
    Vec3 p = Vec3::Zero();
    Curvature curvature{};
};

/// The settings of nearestFeature.
struct FeatureSettings {
    Length radius = millimetres(10.0); ///< largest distance of a feature from the picked point
    Length scale = millimetres(3.0);   ///< size of the fitted patch: finer bumps are smoothed out
};

/// The principal curvatures at a point of a surface, from the least squares fit of
///
///     w = f + d u + e v + (a u^2 + 2 b u v + c v^2) / 2
///
/// to points near it, with w along its normal (Goldfeather and Interrante 2004): the eigenvalues of
/// the quadratic part, positive where convex.
/// @param offsets the differences of these points from it, metres
/// @param normal  of any length
/// @param scale   size of the patch, by which the fit is conditioned
/// @returns nothing where the points do not determine all six coefficients, or the normal is zero.
[[nodiscard]] std::optional<Curvature> fittedCurvature(std::span<const Vec3> offsets,
                                                       const Vec3& normal, Length scale);

/// The feature vertex nearest to a picked point p. A vertex is a feature where no other within
/// `scale` of it has a larger curvature; for a ridge only vertices across it are compared. Ignored
/// are features of less than half the curvature of the strongest within the radius, and of less
/// than 0.1 rad per `scale`. Of two at the same distance the one of lower index is taken.
/// @returns nothing where there is no feature within the radius.
/// @pre the mesh's vertices are welded.
[[nodiscard]] std::optional<FeaturePoint> nearestFeature(const TriangleMesh& mesh, const Vec3& p,
                                                         SurfaceFeature feature,
                                                         const FeatureSettings& settings = {});

} // namespace carina
