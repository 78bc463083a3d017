#pragma once

#include "engine/anatomy/laryngoscopy/upper_airway.h"
#include "engine/geometry/deformation/airway_field.h"

/// What events, and the breath, change of cords, larynx and epiglottis; severities from 0 to 1.
namespace carina::airway_change
{

/// How far the cords close, as a share: of the narrowest that a spasm makes of them, at least what
/// the breath leaves; below 0 where it parts them.
[[nodiscard]] double cordsClosing(double severity, double inspiration);
void moveCords(AirwayField& field, const UpperAirway& airway, double closing);

/// By a web from the commissure on: the more severe, the longer.
void joinCords(AirwayField& field, const UpperAirway& airway, double severity);

void swellEpiglottis(AirwayField& field, const UpperAirway& airway, double severity);

/// Aryepiglottic folds and arytenoids.
void swellEntrance(AirwayField& field, const UpperAirway& airway, double severity);

/// To the back and to the feet, above the vallecula.
void letEpiglottisFall(AirwayField& field, const UpperAirway& airway, double severity);

void moveLarynxForward(AirwayField& field, const UpperAirway& airway, double severity);

/// By a helper: to the back, up and to the patient's right.
void pressLarynx(AirwayField& field, const UpperAirway& airway, double severity);

/// In a swallow: up and to the front, with hyoid bone, tongue's base, trachea and skin.
void raiseLarynx(AirwayField& field, const UpperAirway& airway, double rise);

} // namespace carina::airway_change
