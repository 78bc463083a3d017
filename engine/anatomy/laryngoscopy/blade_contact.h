#pragma once

#include "engine/anatomy/laryngoscopy/blade.h"
#include "engine/anatomy/laryngoscopy/upper_airway.h"

#include <optional>

namespace carina
{

/// What a blade touches at one pose, and the forces that are estimated from how far it displaces
/// what is there. Nothing measures these forces: they are springs, at rest, and know neither how
/// fast a blade moves nor that tissue gives way in time (to about 70 % with a half-time of 4 s,
/// Hastings et al. 1996).
struct BladeContact {
    /// From the blade's underside to the edge of the upper incisors: less than 0 is how deep this
    /// lies inside the blade; nothing where no part of the blade is at it.
    std::optional<Length> teethClearance;
    /// How far the tip is beyond restingWay, on the side of the tongue.
    Length tongueDepth{};
    /// A straight blade has come against the epiglottis from behind, and lifts it; or the tip of
    /// a curved one, which should be in front of it, is on it or just behind.
    bool isOnEpiglottis = false;
    Force tongue{};       ///< kTongueStiffness times the depth
    Force epiglottis{};   ///< the same where the blade lifts it: both are one behind the other
    Force teethByDepth{}; ///< kTeethStiffness times the depth of the incisors in the blade
};

/// Newtons per metre, in the reference man (Hastings et al. 1996: 40 +- 2 N perpendicular to the
/// blade; peak forces 35 +- 12 N, Bucx et al. 1992): of kUsualLift at 45 degrees, by which he has a
/// view of grade 1, 15.6 mm are across the way of the tip. That it is a line is of ours, as is that
/// it grows with UpperAirway::size: so does the stiffness of bodies of one form and one material.
inline constexpr Force kForceOfLift = newtons(40.0);
inline constexpr double kTongueStiffness = kForceOfLift.si / 15.6e-3;

/// Newtons per metre, of ours: 49 N, the mean of the largest forces on the incisors of 65 patients
/// (Bucx et al. 1994), at 5 mm. It stands for all that gives way: teeth, head and blade.
inline constexpr double kTeethStiffness = 49.0 / 5e-3;

/// No spring is believed beyond this; 95 N on a blade were measured in a difficult manikin (Br J
/// Anaesth 2012;108:146).
inline constexpr Force kMostForce = newtons(100.0);

/// To both sides of the midplane, of an adult: about the crowns of two incisors, of ours. The edge
/// is taken as a straight line, as only its midpoint is known.
inline constexpr Length kHalfIncisors = millimetres(15.0);

/// The force of a spring of so many newtons per metre, at most kMostForce; 0 where it is not
/// pressed.
[[nodiscard]] Force springForce(double stiffness, Length depth);

/// What a blade touches at a pose.
/// @param moved the places after they have followed the jaw
[[nodiscard]] BladeContact bladeContact(const UpperAirway& moved, const Blade& blade,
                                        const RigidTransform& X_AL);

} // namespace carina
