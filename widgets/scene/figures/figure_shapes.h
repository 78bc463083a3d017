#pragma once

#include "engine/geometry/deformation/blade_field.h"
#include "engine/geometry/mesh/triangle_mesh.h"

#include <memory>

namespace carina
{

/// Closed meshes with normals of what people wear and hold, metres. Each looks or points along -z
/// of its frame F, with +x to the right and +y up.
struct FigureShapes {
    using Mesh = std::shared_ptr<const TriangleMesh>;

    Mesh head;  ///< a head with the eyes at the origin
    Mesh visor; ///< of its headset, before the eyes
    Mesh gaze;  ///< a short ray from the visor
    Mesh hand;  ///< a right hand with its knuckles at the origin and the index finger stretched out
    Mesh stylus; ///< a stylus with its tip at the origin
    Mesh ray;    ///< from the origin on, for what points
    Mesh handle; ///< of a laryngoscope, upwards from the origin
};

/// Made once and shared.
[[nodiscard]] const FigureShapes& figureShapes();

inline constexpr double kHeadTop = 0.115;   ///< of the head, above the eyes
inline constexpr double kGazeLength = 0.25; ///< from the eyes
inline constexpr double kRayLength = 0.3;   ///< from the origin
/// Sizes of a laryngoscope, of ours: about those of an adult's; no published figures were found.
inline constexpr double kHandleLength = 0.155;
inline constexpr double kHandleRadius = 0.014;

/// A blade of this form, from its handle at the origin of L on.
[[nodiscard]] TriangleMesh bladeMesh(const BladeForm& form);

/// The surface |x/a|^n + |y/b|^n + |z/c|^n = 1 about a centre, as points on rays from it: an
/// ellipsoid for n = 2, nearly a box for a large n (Barr 1981, with one exponent).
/// @pre all radii above 0, exponent at least 2
[[nodiscard]] TriangleMesh superellipsoid(const Vec3& p_F_centre, const Vec3& radii,
                                          double exponent);

} // namespace carina
