#pragma once

#include "engine/geometry/deformation/chest_formula.h"
#include "engine/geometry/mesh/triangle_mesh.h"

namespace carina
{

/// Where a point goes, and how that changes from place to place.
struct FieldDisplacement {
    Vec3 d_A;      ///< metres
    Mat3 gradient; ///< element (i, j) is the derivative of d_i along axis j of A
};

/// What moves one region of the chest: how far each term of the field goes, in shares of the chest.
using ChestMotion = ChestCoefficients<double>;

/// How a chest moves as it breathes: one smooth field over the whole of it, in closed form
///
///     x = x0 + sum_k c_k d_k(x0)
///
/// so that whatever lies in it (lungs, bronchi, ribs, diaphragm) moves by the same function, told
/// apart only by the coefficients c of its region. chest_formula.h has the terms d_k. Continuous
/// with its gradient everywhere. Without shrinking and shifting, nothing moves on the line between
/// the hila, where the airway enters the lungs.
///
/// Frame A of the anatomy; metres.
class ChestField
{
public:
    /// Of a chest that reaches one metre from the origin: for scenes in which nothing breathes.
    ChestField() : ChestField{unitChest(), {-0.3, 0.0, 0.0}, {0.3, 0.0, 0.0}} {}

    /// @param lungs_A    the box around both lungs at rest
    /// @param p_A_right  where the airway enters the right lung; p_A_left likewise. Where they are
    ///                   not on their sides of the box's middle, or not apart, they are moved to
    ///                   kLeastHilum from it.
    /// @param frontShare how far the diaphragm descends in front, of how far at the back
    /// @pre the box has a size along every axis.
    ChestField(const Box& lungs_A, const Vec3& p_A_right, const Vec3& p_A_left,
               double frontShare = kFrontShare);

    [[nodiscard]] FieldDisplacement at(const Vec3& p_A, const ChestMotion& motion) const;

    [[nodiscard]] const ChestFrame<double>& frame() const { return m_frame; }
    /// u, v and h of a point.
    [[nodiscard]] Vec3 shares(const Vec3& p_A) const;

    /// Fitted to the landmarks of five people breathing (docs/deformation.md).
    static constexpr double kFrontShare = 0.11;
    /// Of half the chest's width.
    static constexpr double kLeastHilum = 0.25;

private:
    static Box unitChest();

    ChestFrame<double> m_frame;
};

/// The same numbers in single precision, as graphics cards and deformed() use them.
[[nodiscard]] ChestFrame<float> inSingle(const ChestFrame<double>& frame);
[[nodiscard]] ChestCoefficients<float> inSingle(const ChestMotion& motion);

/// The mesh where the motion takes it, with its exact normals, in single precision as the vertex
/// shader resources/shaders/organ.vert does it. A normal goes with the cofactor of the deformation
/// gradient J = I + grad d; in shares of the chest, with the scale L = diag(perMetre),
///
///     n ~ L cof(I + grad f) L^-1 n0
[[nodiscard]] TriangleMesh deformed(const TriangleMesh& mesh_A, const ChestField& field,
                                    const ChestMotion& motion);

} // namespace carina
