#pragma once

#include "engine/core/units.h"
#include "engine/geometry/deformation/blade_formula.h"
#include "engine/geometry/mesh/triangle_mesh.h"
#include "engine/geometry/rigid_transform.h"

namespace carina
{

/// The form of a laryngoscope's blade in its frame L (origin where handle and blade meet, blade
/// along -z, handle along +y), metres: its tip is at (0, rise, -reach), and its middle lower than
/// the line from heel to tip by `sag`. The sizes are of ours, about those of an adult's curved
/// blade; no published profiles were found.
struct BladeForm {
    double reach = 0.13;
    double rise = 0.012;
    double sag = 0.019;
    double width = 0.016;

    friend bool operator==(const BladeForm&, const BladeForm&) = default;
};

inline constexpr double kBladeHalfThickness = 0.0025; ///< metres; of all blades

/// The middle of a blade at a share of the way from heel to tip, in L.
[[nodiscard]] Vec3 middleOfBlade(const BladeForm& form, double share);

/// Where a larynx tilts with its epiglottis.
struct LarynxHinge {
    Vec3 p_A = Vec3::Zero(); ///< height 0 is there; what lies this far back tilts wholly
    Vec3 up_A = Vec3::UnitZ();
    Vec3 forward_A = -Vec3::UnitY();   ///< unit, perpendicular to up_A
    Length height = millimetres(20.0); ///< of 1 above 0
    Length behind = millimetres(14.0); ///< from there on nothing tilts, at the back
    double slope = 0.0;                ///< by which that begins farther back, the higher; 0 or more
};

/// How the tissue of the mouth and the larynx give way to a laryngoscope's blade, after they have
/// followed the jaw. With the axes of L, y towards the handle, a point moves to
///
///     larynx:  x = p + g(b) r(h) t forward
///     pharynx: x = p + g(d) j(b) u(h) t forward
///     tongue:  q = p + 1.2 g(b) j(b) s(h) t forward,   x = q + w c(f - q_y) y_L
///
/// where f is the height of the blade's face there, c(e) = 0.4 (m + sqrt(m^2 + 4 k^2)) with
/// m = e + 7.2 mm a soft contact, w in 0..1 fades beside the blade (of a narrow one within less,
/// and its k and 7.2 mm are smaller, as kUsualHalfWidth says), before its heel and beyond its tip,
/// h is a height above the hinge of the larynx, r grows with it in proportion but near the hinge, s
/// from 0 to 1, u as r up to height 1 and back to 0 above it, where the palate is, g fades from 1
/// to 0 towards the back, and j towards the chin. b begins farther back the higher a place is, as
/// an epiglottis leans; d does not, and of the pharynx nothing moves that lies behind the hinge:
/// its wall is fixed to the spine.
///
/// Nothing folds, wherever the blade is. The determinant of the deformation gradient is at least 1
/// for the larynx, as `forward` is perpendicular to the direction in which h grows, and g grows
/// along it. For the pharynx, too, g grows along `forward`, and it is at least 0.2 (1 - 1.2 t j'
/// with t at most twice the length over which g fades); for the tongue the product of at least this
/// and of 1 - w c' with 0 < c' < 0.8, so that a thin sheet that a blade presses flat keeps a fifth
/// of its thickness, and its triangles do not pass through each other. Where w is 1 nothing of the
/// tongue stays inside the blade up to a depth of 28.8 mm, as c(e) > e there.
class BladeField
{
public:
    /// No blade: nothing moves.
    BladeField() = default;
    /// A blade at a pose; the larynx is not tilted. @pre reach and width above 0
    BladeField(const BladeForm& form, const RigidTransform& X_AL);

    /// Takes what lies at height 1 above the hinge so far forward: by 0 to twice its `behind`,
    /// whatever is asked for. Nothing is tilted where a length of the hinge is not above 0, as
    /// between places that lie so in no throat.
    void tiltLarynx(const LarynxHinge& hinge, Length tilt);

    [[nodiscard]] const BladeFrame<double>& frame() const { return m_frame; }
    /// Whether anything is moved.
    [[nodiscard]] bool isThere() const { return m_frame.halfWidth > 0.0; }

private:
    BladeFrame<double> m_frame;
};

/// The same values in single precision, as graphics cards and deformed() use them.
[[nodiscard]] BladeFrame<float> inSingle(const BladeFrame<double>& frame);

/// The deformed mesh with its exact normals, in single precision: the reference for the vertex
/// shader resources/shaders/organ.vert.
[[nodiscard]] TriangleMesh deformed(const TriangleMesh& mesh_A, const BladeField& blade,
                                    AirwayTissue tissue);

} // namespace carina
