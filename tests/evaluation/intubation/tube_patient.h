#pragma once

#include "engine/anatomy/airway/airway_shapes.h"
#include "engine/anatomy/anatomy.h"
#include "engine/anatomy/shapes/tube.h"
#include "evaluation/intubation/motion_patient.h"

#include <memory>

namespace carina::test
{

/// The landmarks of a made patient with surfaces that are tubes along known lines: main bronchi
/// along the rods of AirwaySolid, an oesophagus behind the trachea, cords and epiglottis. It is
/// made in milliseconds.
Anatomy tubePatient(const PatientDimensions& dimensions);

/// The rod of a main bronchus there, in A.
AirwayRod mainBronchusOf(const PatientDimensions& dimensions, Side side);

/// How far behind the trachea's axis the axis of that oesophagus is, metres.
inline constexpr double kBehindTrachea = 0.013;

/// That patient, the boy of 12 years, as motions know him.
std::shared_ptr<const MotionPatient> boyOfTubes();

/// A tube of 6.5 mm for him, as long as the deepest motions want it.
TubeShape tubeOfBoy();

} // namespace carina::test
