#pragma once

#include "engine/geometry/deformation/chest_field.h"
#include "engine/geometry/deformation/neck_field.h"
#include "engine/geometry/deformation/throat_formula.h"
#include "engine/geometry/rigid_transform.h"

namespace carina
{

/// How the tissue between the lower jaw and the carina follows the jaw: tongue, floor of the mouth,
/// hyoid, epiglottis, larynx, pharynx, and the trachea, which stretches. A point p moves to
///
///     x = p + S(p) (X_AJ a - a) + S(p)^2 (R_AJ - I) (p - a)
///
/// where X_AJ is the motion of the mandible from its pose in the surfaces, a an anchor point behind
/// the incisors, and S the share by which p follows: 0 at the carina and below, 1 where the tissue
/// is fixed to the jaw, so that x = X_AJ p there. In between a point takes the share S of the
/// anchor's displacement and the share S^2 of the rotation about the anchor. S is a product of
/// three smooth steps (throat_formula.h): along the trachea, from the back to the front, and below
/// the roof of the mouth. S and its gradient are continuous, and so are positions and normals.
///
/// The steps were chosen for these findings:
/// - the lower 60 % of the way from the carina to the cords keep their length and the rest
///   stretches (Wong et al, Anesth Analg 2008;107:989: from flexion to extension the distance from
///   sternal notch to cords grows by 17.4 mm, that from carina to notch by -1.2 +- 7.0 mm; cords to
///   carina are 136 mm, of which 82 lie below the notch);
/// - the hyoid follows a jaw that is moved forward by half (Kuna et al, Anesthesiology
///   2008;109:605: 5.1 mm of 10.0), and moves down and back as the mouth opens (Muto and Kanazawa,
///   Oral Surg 1994;77:451);
/// - skull, palate, spine and the posterior wall of the pharynx do not move.
///
/// Positions in the anatomy frame A, metres.
class ThroatField
{
public:
    /// A field without motion: S is 0 everywhere.
    ThroatField() = default;

    /// The points are those of AirwayLandmarks. Where the glottis is within kLeast of one of the
    /// others, S is 0 everywhere.
    ThroatField(const Vec3& p_A_carina, const Vec3& p_A_glottis, const Vec3& p_A_incisors);

    [[nodiscard]] const ThroatFrame<double>& frame() const { return m_frame; }

    static constexpr double kLeast = 0.01; ///< metres

private:
    ThroatFrame<double> m_frame;
};

/// A throat, the pose of its mandible, and that of head and neck, which moves all of it first: what
/// follows the jaw then does so in the frame of the head.
struct FollowingThroat {
    ThroatField field;
    RigidTransform X_AJ; ///< motion of the mandible from its pose in the surfaces, in that frame
    NeckField neck{};
};

/// The displacement by the jaw of what the neck has taken to p_A, and its gradient.
[[nodiscard]] DisplacementAt<double> throatPull(const FollowingThroat& throat, ThroatTissue tissue,
                                                const Vec3& p_A);

/// R_AJ - I and the translation of X_AJ.
[[nodiscard]] JawShift<double> jawShift(const RigidTransform& X_AJ);

/// The same values in single precision, as graphics cards and deformed() use them.
[[nodiscard]] ThroatFrame<float> inSingle(const ThroatFrame<double>& frame);
[[nodiscard]] JawShift<float> inSingle(const JawShift<double>& jaw);

/// The deformed mesh with its exact normals n ~ cof(I + grad d) n0, in single precision: the
/// reference for the vertex shader resources/shaders/organ.vert, which applies it after breathing.
/// Unchanged where X_AJ is the identity. @param mesh_A as the neck has it
[[nodiscard]] TriangleMesh deformed(const TriangleMesh& mesh_A, const FollowingThroat& throat,
                                    ThroatTissue tissue);

} // namespace carina
