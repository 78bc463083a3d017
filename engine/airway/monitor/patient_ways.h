#pragma once

#include "engine/anatomy/airway/centreline.h"
#include "engine/anatomy/laryngoscopy/upper_airway.h"

#include <functional>
#include <optional>
#include <span>

namespace carina
{

/// The ways that a tube can take in one patient, and the planes by which its place is told. Frame
/// A, metres.
struct PatientWays {
    Centreline overTongue; ///< from the incisors to the middle of the glottis; two points at least
    Centreline trachea;    ///< from there to the carina; two points at least
    Centreline oesophagus; ///< from behind the larynx, at the height of the cords, down
    Vec3 p_A_rightEnd = Vec3::Zero(); ///< of the right main bronchus, which begins at the carina
    Vec3 p_A_leftEnd = Vec3::Zero();
    Vec3 p_A_notch = Vec3::Zero();        ///< interarytenoid: the end of the glottis behind
    Vec3 p_A_frontOfCords = Vec3::Zero(); ///< kBesideCords from the middle of the glottis, in the
    Vec3 p_A_backOfCords = Vec3::Zero();  ///< plane of the cords; what shears them, as a blade
    Vec3 p_A_leftOfCords = Vec3::Zero();  ///< does, turns that plane less than its normal line
    double size = 1.0;                    ///< UpperAirway::size

    [[nodiscard]] const Vec3& p_A_incisors() const { return overTongue.front(); }
    [[nodiscard]] const Vec3& p_A_glottis() const { return trachea.front(); }
    [[nodiscard]] const Vec3& p_A_carina() const { return trachea.back(); }
    /// The normal of the cords' plane, towards the head; unit.
    [[nodiscard]] Vec3 up_A() const
    {
        const Vec3 forward = p_A_frontOfCords - p_A_backOfCords;
        return forward.cross(p_A_leftOfCords - p_A_glottis()).normalized();
    }
    /// The normal of the plane at the incisors, into the mouth: the way's direction there; unit.
    [[nodiscard]] Vec3 inward_A() const;
};

inline constexpr Length kBesideCords = millimetres(5.0);

/// Main bronchi where a patient has no such parts: their angles from the trachea and their lengths
/// in grown people (AccessAnesthesiology; 26.9 +- 7.0 and 46.2 +- 8.0 degrees, 25 and 50 mm).
inline constexpr Angle kRightBronchusAngle = degrees(26.9);
inline constexpr Angle kLeftBronchusAngle = degrees(46.2);
inline constexpr Length kRightBronchus = millimetres(25.0);
inline constexpr Length kLeftBronchus = millimetres(50.0);
/// From the middle of an adult's trachea to that of the oesophagus behind it, where a patient has
/// no such part: half the depth of a trachea (17.1 mm, men, by MRI: Korean J Anesthesiol 1993), and
/// 5.4 mm for the wall and half the oesophagus, as in the built-in patient.
inline constexpr Length kTracheaToOesophagus = millimetres(13.9);
/// From the notch to the middle of a tube behind the larynx of an adult, at the height of the
/// cords: arytenoids and cricoid, and half a tube. Of ours.
inline constexpr Length kNotchToHypopharynx = millimetres(15.0);

/// The ways of a patient, as its surfaces are made.
///
/// - Bronchi: from the carina to the mean of the farthest vertices of the parts of role
///   RightMainBronchus and LeftMainBronchus; else by the angles above, in the frontal plane.
/// - Oesophagus: the means of the horizontal sections of the part of that role; else a line behind
///   the trachea, at kTracheaToOesophagus. It begins kNotchToHypopharynx behind the notch.
/// - Cords: those of `upper`; without them the cords' plane is across the trachea, and the glottis
///   is as long as kReferenceGlottis. Lengths of an adult are in proportion to the larynx or the
///   trachea.
///
/// @pre the landmarks' path has a point
[[nodiscard]] PatientWays patientWays(const AirwayLandmarks& landmarks,
                                      const std::optional<UpperAirway>& upper,
                                      std::span<const AnatomyPart> parts);

/// The share of a place's motion by the jaw that a tube's way has there: 0 at the upper incisors,
/// which the jaw leaves where they are, and 1 from kAlongPalate of the way to the glottis on, up to
/// which the way goes along the palate. kAlongPalate is of ours.
[[nodiscard]] double shareOfJaw(const PatientWays& ways, const Vec3& p_A);
inline constexpr double kAlongPalate = 0.4;

/// The same ways where neck, jaw, events and blade have taken them.
/// @param drawn where a place of the surfaces is drawn
[[nodiscard]] PatientWays moved(PatientWays ways, const std::function<Vec3(const Vec3&)>& drawn);

/// The place on a line that is nearest to a point. The line goes on straight beyond its last point.
struct PlaceOnWay {
    Vec3 p_A = Vec3::Zero();
    Length along{}; ///< from the first point; more than the line's length beyond its end
    Length off{};   ///< distance of the point from there
};
/// @pre two points at least, the last two of which differ
[[nodiscard]] PlaceOnWay nearestOnWay(std::span<const Vec3> line, const Vec3& p_A);

} // namespace carina
