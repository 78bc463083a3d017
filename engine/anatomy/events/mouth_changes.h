#pragma once

#include "engine/anatomy/laryngoscopy/upper_airway.h"
#include "engine/geometry/deformation/airway_field.h"

/// What events change of lips, teeth, tongue and pharynx; severities and shares from 0 to 1.
namespace carina::airway_change
{

/// @pre the airway has a tongue
void swellTongue(AirwayField& field, const UpperAirway& airway, double severity);

/// Lips and the front of the tongue, where the airway has them.
void swellMouth(AirwayField& field, const UpperAirway& airway, double severity);

/// By swelling, and by fat.
void narrowPharynx(AirwayField& field, const UpperAirway& airway, double swelling, double fat);

/// Palate and uvula up and to the back, towards the wall of the pharynx, as in a swallow.
void raisePalate(AirwayField& field, const UpperAirway& airway, double rise);

/// To the front and down as the face has it. Roots and jaw stay.
void protrudeIncisors(AirwayField& field, const UpperAirway& airway, double severity);

/// The crown of one of them leans to the front and stands lower, by 1.5 mm at its edge in a man;
/// its root, the other teeth and the gum stay. A tooth that can be moved by more than 1 mm has the
/// worst of the grades of mobility (Miller, Textbook of Periodontia, 3rd ed. 1950).
void loosenIncisor(AirwayField& field, const UpperAirway& airway, double severity);

} // namespace carina::airway_change
