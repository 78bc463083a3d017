#pragma once

#include "engine/anatomy/laryngoscopy/upper_airway.h"
#include "engine/geometry/deformation/airway_field.h"

/// What events change of trachea and neck; severities from 0 to 1.
namespace carina::airway_change
{

/// By a stenosis from all sides, by a goitre from both. @pre the airway has a windpipe
void narrowTrachea(AirwayField& field, const UpperAirway& airway, double stenosis, double goitre);

/// To the patient's right. @pre likewise
void moveTrachea(AirwayField& field, const UpperAirway& airway, double deviation, double goitre);

/// The skin before a goitre, where the airway has it.
void bulgeNeck(AirwayField& field, const UpperAirway& airway, double severity);

/// What fat does but to the walls of the pharynx: the base of the tongue, and the skin all round.
void thickenNeck(AirwayField& field, const UpperAirway& airway, double severity);

} // namespace carina::airway_change
