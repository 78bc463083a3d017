#pragma once

#include "engine/geometry/mesh/triangle_mesh.h"
#include "engine/lungs/drawing/volume_cubic.h"

#include <array>
#include <span>

namespace carina
{

/// The volume that closed meshes enclose together, as an exact function of the amplitudes s of
/// kModes displacement fields d that move their vertices:
///
///     x_i(s) = x_i + sum_k s_k d_ki        V(s) = sum_jkl T_jkl a_j a_k a_l,  a = (1, s)
///
/// The signed volume of a closed mesh is a sum of determinants of the corners of its triangles,
/// each a polynomial of third degree in s. T holds the coefficients of this polynomial, summed once
/// over all triangles. Volumes of several meshes add up.
class VolumeTensor
{
public:
    static constexpr std::size_t kModes = 5;
    using Amplitudes = std::array<double, kModes>;
    /// Displacements at amplitude 1, one for each vertex, metres.
    using Fields = std::array<std::vector<Vec3>, kModes>;

    /// Adds a mesh. Sums are in double precision over the single-precision vertices that are drawn,
    /// relative to the first vertex.
    /// @pre the mesh is closed (otherwise V would depend on the origin); each field has one
    ///      displacement for each vertex.
    void add(const TriangleMesh& mesh, const Fields& fields);

    /// The volume at the amplitudes given + s along, as a cubic in s.
    [[nodiscard]] VolumeCubic along(const Amplitudes& given, const Amplitudes& along) const;

private:
    static constexpr std::size_t kFields = kModes + 1; ///< 0 is the mesh at rest

    /// T for j <= k <= l only; each element includes those of the other orders of its three
    /// indices.
    std::array<std::array<std::array<double, kFields>, kFields>, kFields> m_t{};
};

} // namespace carina
