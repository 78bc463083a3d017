#pragma once

#include "engine/geometry/deformation/chest_field.h"
#include "engine/geometry/deformation/throat_formula.h"
#include "engine/geometry/rigid_transform.h"

namespace carina
{

/// How what lies between the lower jaw and the carina follows the jaw: tongue, floor of the mouth,
/// hyoid, epiglottis, larynx, pharynx, and the trachea, which stretches. A closed form of the
/// place:
///
///     x = p + S(p) (X_AJ a - a) + S(p)^2 (R_AJ - I) (p - a)
///
/// with X_AJ the pose of the mandible from where the surfaces have it, and a share S that
/// is 0 at the carina and below it and 1 where the part is fixed to the jaw: there x = X_AJ p. What
/// hangs from the jaw goes by its share of what the place a goes, behind the lower incisors, and
/// turns about it by less. S is a product of three smooth steps (throat_formula.h): along the
/// trachea, from the back to the front, and below the roof of the mouth. It is continuous with its
/// slope, and so are positions and normals.
///
/// What the steps were chosen for:
/// - the trachea's lower 61 % keep their length, the rest stretches (Wong et al, Anesth Analg
///   2008;107:989: from flexion to extension the cords go 17.4 mm away from the sternal notch, the
///   notch -1.2 +- 7.0 mm from the carina, cords to carina 136 mm, of these 82 below the notch);
/// - the hyoid follows half of a jaw that is brought forward (Kuna et al, Anesthesiology
///   2008;109:605: 5.1 mm of 10.0), and goes down and back as the mouth opens (Muto and Kanazawa,
///   Oral Surg 1994;77:451);
/// - skull, palate, spine and the wall of the pharynx before it stay.
///
/// Frame A of the anatomy; metres.
class ThroatField
{
public:
    /// Of nobody: nothing follows.
    ThroatField() = default;

    /// The points are those of AirwayLandmarks. Where the glottis is within kLeast of one of the
    /// others, nothing follows.
    ThroatField(const Vec3& p_A_carina, const Vec3& p_A_glottis, const Vec3& p_A_incisors);

    /// S, from 0 to 1.
    [[nodiscard]] double share(const Vec3& p_A, ThroatTissue tissue) const;
    [[nodiscard]] FieldDisplacement at(const Vec3& p_A, const RigidTransform& X_AJ,
                                       ThroatTissue tissue) const;

    [[nodiscard]] const ThroatFrame<double>& frame() const { return m_frame; }

    static constexpr double kLeast = 0.01; ///< metres

private:
    ThroatFrame<double> m_frame;
};

/// A throat, and where the mandible is.
struct FollowingThroat {
    ThroatField field;
    RigidTransform X_AJ; ///< from where the surfaces have it
};

[[nodiscard]] JawShift<double> jawShift(const RigidTransform& X_AJ);

/// The same numbers in single precision, as graphics cards and deformed() use them.
[[nodiscard]] ThroatFrame<float> inSingle(const ThroatFrame<double>& frame);
[[nodiscard]] JawShift<float> inSingle(const JawShift<double>& jaw);

/// The mesh where the jaw takes it, with its exact normals n ~ cof(I + grad d) n0, in single
/// precision as the vertex shader resources/shaders/organ.vert does it after breathing. With the
/// mandible where the surfaces have it, the mesh as it is.
[[nodiscard]] TriangleMesh deformed(const TriangleMesh& mesh_A, const FollowingThroat& throat,
                                    ThroatTissue tissue);

} // namespace carina
