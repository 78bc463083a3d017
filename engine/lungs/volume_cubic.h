#pragma once

#include "engine/core/result.h"
#include "engine/core/units.h"
#include "engine/geometry/deformable_mesh.h"

#include <array>

namespace carina
{

/// The volume that closed deformable meshes enclose together, as a function of their common
/// amplitude s, exactly:
///
///     V(s) = c0 + c1 s + c2 s^2 + c3 s^3
///
/// The signed volume of a closed mesh is a sum of determinants (x_i + s d_i, x_j + s d_j,
/// x_k + s d_k) / 6, each of which is a cubic in s. Volumes of several meshes add.
struct VolumeCubic {
    std::array<double, 4> c{}; ///< m^3

    [[nodiscard]] Volume at(double s) const;

    VolumeCubic& operator+=(const VolumeCubic& other);
};

/// The cubic of one mesh: double sums over the single-precision vertices that are drawn, about the
/// mesh's first vertex.
/// @pre the mesh is closed, or V depends on where the origin is.
[[nodiscard]] VolumeCubic volumeCubic(const DeformableMesh& mesh);

/// The amplitude within kLeastAmplitude and kGreatestAmplitude at which the volume is `volume`,
/// exact to the last digits of double; where the cubic has several, the one nearest to `nearest`.
///
/// @returns VolumeUnreachable when no amplitude within the range has it; NotFinite for NaN or inf.
[[nodiscard]] Result<double> amplitudeFor(const VolumeCubic& cubic, Volume volume, double nearest);

} // namespace carina
