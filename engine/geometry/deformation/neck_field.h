#pragma once

#include "engine/core/units.h"
#include "engine/geometry/deformation/neck_formula.h"
#include "engine/geometry/mesh/triangle_mesh.h"
#include "engine/geometry/rigid_transform.h"

namespace carina
{

/// How head and neck lie, from the neutral position in which surfaces are made.
struct HeadPosition {
    Angle flexion{};   ///< of the neck on the trunk, to the front
    Angle extension{}; ///< of the head against the neck, to the back

    friend bool operator==(const HeadPosition&, const HeadPosition&) = default;
};

/// The neck is flexed by 35 degrees (Horton, Fahy and Charters, Br J Anaesth 1989;62:6, by angle
/// finder); occiput, atlas and axis extended by 24.2 +- 5.6 (Takenaka et al, Can J Anesth
/// 2007;54:129, 30 volunteers by X-ray). The face then looks down by 11 degrees; Horton's looked up
/// by 15, as the middle of a neck extends, too.
inline constexpr HeadPosition kSniffing{degrees(35.0), degrees(24.2)};
/// The head extended without a pillow, by 20.4 +- 5.1 degrees (Takenaka et al).
inline constexpr HeadPosition kHeadExtended{{}, degrees(20.4)};
/// The neck flexed as in the sniffing position, and the head not extended against it: of ours.
inline constexpr HeadPosition kNeckFlexed{degrees(35.0), {}};

/// The positions that are drawn.
inline constexpr Angle kLeastFlexion = degrees(-25.0);
inline constexpr Angle kMostFlexion = degrees(35.0);
inline constexpr Angle kLeastExtension = degrees(-10.0);
inline constexpr Angle kMostExtension = degrees(30.0); ///< while the neck is not flexed

/// The position that is drawn in place of this one: each angle within its limits, and the head
/// extended less, the more the neck is flexed, from 20 degrees on no more than in the sniffing
/// position: no measured one was found beyond that, and the skin before the neck would pass through
/// itself. That this limit falls evenly up to 20 degrees is of ours.
[[nodiscard]] HeadPosition withinReach(const HeadPosition& position);

/// The same of who has this way from incisors to glottis. Where it is shorter than kGrownWay the
/// neck is flexed less, in proportion (22 degrees in a newborn): the chest comes nearer to the chin
/// of an infant, whose neck is short and round, and skin that lies farther before the hinge than
/// NeckField reaches would pass through itself. Of ours; no measured limit was found. Little that
/// is done is lost: the large occiput flexes the neck by itself, and a slight extension of the head
/// brings the line of sight nearer to the larynx' axis in infants and young children (Vialet et
/// al., Paediatr Anaesth 2008;18:525, by MRI).
[[nodiscard]] HeadPosition withinReach(const HeadPosition& position, Length way);
inline constexpr Length kGrownWay = millimetres(79.0); ///< 0.9 of that of the man of BodyParts3D

/// How everything between trunk and head moves as these lie in another position. First the head is
/// extended about the joints of occiput and atlas, then the neck flexed, with the head, about the
/// disc between the sixth and the seventh cervical vertebra. Each of the two turns a place about an
/// axis across the body,
///
///     x = c + R(a S(h)) (p - c)
///
/// by a share S of the angle a: 0 on the side of the trunk, 1 on the side of the head, which so
/// moves rigidly, its frame U to X_AU; in between S is the smooth step of a height h in the neck.
/// That of flexion grows along the neck, which leans forward by 20 degrees. That of extension has
/// the form of a roof with its ridge above the joints of the head: in front its level surfaces lead
/// down between larynx and chin, behind from the base of the skull to the nape. So the larynx stays
/// with the neck, and what lies between it and the jaw is drawn out.
///
/// With m = grad h . (e_x x (p - c)) the determinant of the deformation gradient of each is exactly
///
///     det = 1 + a S'(h) m,   S' at most 1.5,
///
/// and that of both their product. For flexion -m is how far p lies in front of the hinge, across
/// the neck, over the length of the ramp (0.92 L, L from incisors to glottis): at 35 degrees det is
/// at least 1 - 0.611 * 1.5 * 0.8 / 0.92 = 0.20 up to 0.8 L in front. In the positions that are
/// drawn it is at least kLeastDeterminant for both, so nothing folds, within the reach: from 0.8 L
/// in front of the hinge of the neck to 1.0 L behind it, and from 1.0 L in front of that of the
/// head to 0.75 L behind it (66 mm in a man). Farther away the skin of a very thick neck could
/// fold.
///
/// Lengths are in proportion to L; the figures are of ours, from the vertebrae and the larynx of
/// the man whose surfaces are published (BodyParts3D).
class NeckField
{
public:
    /// Neutral: nothing moves.
    NeckField() = default;
    /// The points are those of AirwayLandmarks; a position out of reach is drawn as withinReach has
    /// it for their distance. Where they are within kLeast of each other nothing moves.
    NeckField(const Vec3& p_A_glottis, const Vec3& p_A_incisors, const HeadPosition& position);

    [[nodiscard]] const NeckFrame<double>& frame() const { return m_frame; }
    /// The pose of the head, which coincides with A in the neutral position.
    [[nodiscard]] const RigidTransform& X_AU() const { return m_X_AU; }
    [[nodiscard]] bool isBent() const
    {
        return m_frame.extension.angle != 0.0 || m_frame.flexion.angle != 0.0;
    }
    /// The position, as it is drawn.
    [[nodiscard]] HeadPosition position() const
    {
        return {radians(m_frame.flexion.angle), radians(0.0 - m_frame.extension.angle)};
    }

    /// Where a place of the neutral position goes.
    [[nodiscard]] Vec3 placed(const Vec3& p_A) const
    {
        return p_A + neckPull<double>(m_frame, p_A).d;
    }
    /// By how much what is at a place of the neutral position turns about +x.
    [[nodiscard]] Angle turnAt(const Vec3& p_A) const;

    static constexpr double kLeast = 0.01;            ///< metres
    static constexpr double kLeastDeterminant = 0.15; ///< within the reach

private:
    NeckFrame<double> m_frame;
    RigidTransform m_X_AU;
};

/// Into the frame F of a body that goes with the head, X_AF being its pose in the neutral position,
/// from where the neck has taken a place: (X_AU X_AF)^-1.
[[nodiscard]] RigidTransform outOfNeck(const NeckField& neck, const RigidTransform& X_AF);

/// Where in F such a body has a place p_F of the neutral position while it is bent as what is
/// around it, as a tube in the airway: (X_AU X_AF)^-1 N(X_AF p_F), N being placed().
[[nodiscard]] Vec3 bentInBody(const NeckField& neck, const RigidTransform& X_AF, const Vec3& p_F);

/// X_AU as HeadPose.
[[nodiscard]] HeadPose<double> headPose(const NeckField& neck);

/// The same values in single precision, as graphics cards and deformed() use them.
[[nodiscard]] NeckFrame<float> inSingle(const NeckFrame<double>& frame);
[[nodiscard]] HeadPose<float> inSingle(const HeadPose<double>& head);

/// The deformed mesh with its exact normals, in single precision: the reference for the vertex
/// shader resources/shaders/organ.vert, which applies it before tissue follows the jaw. Unchanged
/// in the neutral position.
[[nodiscard]] TriangleMesh deformed(const TriangleMesh& mesh_A, const NeckField& neck);

} // namespace carina
