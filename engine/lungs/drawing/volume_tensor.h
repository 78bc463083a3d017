#pragma once

#include "engine/geometry/mesh/triangle_mesh.h"
#include "engine/lungs/drawing/volume_cubic.h"

#include <array>
#include <span>

namespace carina
{

/// The volume that closed meshes enclose together, as a function of the amplitudes of kModes
/// displacement fields that move their vertices, exactly:
///
///     x_i(s) = x_i + sum_k s_k d_ki        V(s) = sum_jkl T_jkl a_j a_k a_l,  a = (1, s)
///
/// The signed volume of a closed mesh is a sum of determinants of its triangles' corners, each of
/// which is of third degree in s; T is what remains of them when it is summed over the triangles
/// once. Volumes of several meshes add.
class VolumeTensor
{
public:
    static constexpr std::size_t kModes = 5;
    using Amplitudes = std::array<double, kModes>;
    /// Displacements at amplitude 1, one for each vertex, metres.
    using Fields = std::array<std::vector<Vec3>, kModes>;

    /// Double sums over the single-precision vertices that are drawn, about the first one.
    /// @pre the mesh is closed, or V depends on where the origin is; fields have its vertex count.
    void add(const TriangleMesh& mesh, const Fields& fields);

    /// The volume along a line: at the amplitudes given + s along, as a cubic in s.
    [[nodiscard]] VolumeCubic along(const Amplitudes& given, const Amplitudes& along) const;

private:
    static constexpr std::size_t kFields = kModes + 1; ///< 0 is the mesh at rest

    /// T at j <= k <= l, with what the other orders of the same three add.
    std::array<std::array<std::array<double, kFields>, kFields>, kFields> m_t{};
};

} // namespace carina
