#pragma once

#include "engine/anatomy/anatomy.h"
#include "engine/geometry/deformable_mesh.h"

namespace carina
{

/// Where a point of a lung goes at amplitude 1, and how that changes from place to place.
struct Displacement {
    Vec3 d_A;      ///< metres
    Mat3 gradient; ///< element (i, j) is the derivative of d_i along axis j
};

/// How one lung moves as it fills, as one smooth field over the lung's own box: every lobe and
/// every level of detail of the lung takes its displacement from the same field, so that lobes stay
/// joined at their fissures.
///
/// The base follows the diaphragm downward, furthest at the back, and less the nearer to the apex.
/// The front follows the ribs forward and, in its upper half, upward; the side follows them
/// outward. Nothing moves at the hilum and on the mediastinal face of the box. All amplitudes are
/// shares of the lung's height. At amplitude 1 an adult's domes go down by 18 mm, the front moves
/// forward by 4 and the side outward by 2 mm: what was measured in quiet breathing (dome 18 +- 3
/// mm, ribs 3 to 5 mm forward and 1 to 2 mm outward). It takes an amplitude of 1.4 to 1.9 to hold a
/// tidal volume of 7 ml/kg, because the mediastinal side is held fast here and slides along the
/// heart in life.
///
/// Continuous with its gradient everywhere. I + s A keeps its orientation (no fold) for every s
/// within kLeastAmplitude and kGreatestAmplitude.
class DisplacementMode
{
public:
    /// The mode of a lung that fills `lung_A`, on `side`, anchored at its hilum H.
    /// @pre the box has a size along every axis.
    DisplacementMode(const Box& lung_A, Side side, const Vec3& p_AH);

    [[nodiscard]] Displacement at(const Vec3& p_A) const;

private:
    Box m_lung_A;
    Vec3 m_outward_A;
    double m_medial_x = 0.0; ///< x of the mediastinal face of the box
    Vec3 m_p_AH;
};

/// Amplitudes that a DisplacementMode may be drawn with: from well below rest to seven breaths.
inline constexpr double kLeastAmplitude = -1.0;
inline constexpr double kGreatestAmplitude = 7.0;

/// The mesh with the mode's displacement and the terms of its exact normal at every vertex.
/// @pre the mesh has normals.
[[nodiscard]] DeformableMesh makeDeformable(const TriangleMesh& mesh_A,
                                            const DisplacementMode& mode);

} // namespace carina
