#pragma once

#include "engine/anatomy/laryngoscopy/upper_airway.h"
#include "engine/geometry/deformation/airway_field.h"

/// What the events of an airway have in common (airwayChanges).
namespace carina::airway_change
{

/// Lengths of events are those of a man at severity 1. Whatever is of the larynx is in proportion
/// to his glottis as upperAirwayOf finds it, whatever is of the epiglottis to its height, all else
/// to his way from incisors to glottis.
inline constexpr Length kMansGlottis = millimetres(24.5);
inline constexpr Length kMansEpiglottis = millimetres(29.1);

/// Those that the lower lip, and the upper one with its gum, are of.
inline constexpr auto kLipsTissues =
    AirwayTissues(only(AirwayTissue::Throat) | only(AirwayTissue::Skin));

/// Across the midplane, to the right of who looks at the patient from the front.
inline Vec3 rightOf(const UpperAirway& airway) { return airway.up_A.cross(airway.forward_A()); }
inline Vec3 patientsRightOf(const UpperAirway& airway) { return -rightOf(airway); }

/// Two narrowings of one lumen by these shares, one after the other.
inline double bothShares(double one, double other) { return 1.0 - (1.0 - one) * (1.0 - other); }

} // namespace carina::airway_change
