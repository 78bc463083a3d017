#pragma once

#include "engine/geometry/deformation/chest_formula.h"
#include "engine/geometry/mesh/triangle_mesh.h"

namespace carina
{

/// The displacement of a point, and its spatial derivative.
struct FieldDisplacement {
    Vec3 d_A;      ///< metres
    Mat3 gradient; ///< element (i, j) is the derivative of d_i along axis j of A
};

/// The motion of one region of the chest: the coefficient of each term of the field, in shares of
/// the chest's size.
using ChestMotion = ChestCoefficients<double>;

/// The breathing motion of a chest: one smooth displacement field in closed form
///
///     x = x0 + sum_k c_k d_k(x0)
///
/// All parts of the chest (lungs, bronchi, ribs, diaphragm) move by the same function; only the
/// coefficients c_k differ between regions. chest_formula.h has the terms d_k, docs/deformation.md
/// describes them. The field and its gradient are continuous everywhere. Unless the terms
/// `shrink` and `shift` are used, points on the curve between the hila, where the airway enters the
/// lungs, do not move.
///
/// Positions in the anatomy frame A, metres.
class ChestField
{
public:
    /// A chest that reaches one metre from the origin: for scenes in which nothing breathes.
    ChestField() : ChestField{unitChest(), {-0.3, 0.0, 0.0}, {0.3, 0.0, 0.0}} {}

    /// @param lungs_A    the box around both lungs at rest
    /// @param p_A_right  the right hilum, where the airway enters the right lung; p_A_left the left
    ///                   one. A hilum that is not at least kLeastHilum from the middle of the box
    ///                   on its own side is moved there along x.
    /// @param frontShare descent of the diaphragm in front, relative to that at the back
    /// @pre the box has a size along every axis.
    ChestField(const Box& lungs_A, const Vec3& p_A_right, const Vec3& p_A_left,
               double frontShare = kFrontShare);

    /// The displacement at p_A.
    [[nodiscard]] FieldDisplacement at(const Vec3& p_A, const ChestMotion& motion) const;

    [[nodiscard]] const ChestFrame<double>& frame() const { return m_frame; }
    /// The coordinates u, v and h of a point (see Shares).
    [[nodiscard]] Vec3 shares(const Vec3& p_A) const;

    /// Fitted to the landmarks of five people breathing (docs/deformation.md).
    static constexpr double kFrontShare = 0.11;
    /// As a share of half the chest's width.
    static constexpr double kLeastHilum = 0.25;

private:
    static Box unitChest();

    ChestFrame<double> m_frame;
};

/// The same values in single precision, as graphics cards and deformed() use them.
[[nodiscard]] ChestFrame<float> inSingle(const ChestFrame<double>& frame);
[[nodiscard]] ChestCoefficients<float> inSingle(const ChestMotion& motion);

/// The deformed mesh with its exact normals, in single precision: the reference for the vertex
/// shader resources/shaders/organ.vert. Normals transform with the cofactor matrix of the
/// deformation gradient J = I + grad d; in shares of the chest, with the scale L = diag(perMetre),
///
///     n ~ L cof(I + grad f) L^-1 n0
///
/// @pre the mesh has normals.
[[nodiscard]] TriangleMesh deformed(const TriangleMesh& mesh_A, const ChestField& field,
                                    const ChestMotion& motion);

} // namespace carina
