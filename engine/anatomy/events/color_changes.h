#pragma once

#include "engine/anatomy/laryngoscopy/upper_airway.h"
#include "engine/geometry/deformation/airway_field.h"

/// What events change of the colours of tissue; severities from 0 to 1. The colours are of ours.
namespace carina::airway_change
{

/// Where swellMouth and swellEntrance swell it: little blood is left in what is so tense.
void makePale(AirwayField& field, const UpperAirway& airway, double severity);

/// The epiglottis and what of the folds is at it, not the cords.
void reddenEpiglottis(AirwayField& field, const UpperAirway& airway, double severity);

/// Red from the mouth to the cords, and soot on tongue, palate and epiglottis.
void scorch(AirwayField& field, const UpperAirway& airway, double severity);

} // namespace carina::airway_change
