#pragma once

#include "engine/anatomy/patient/body_plan.h"
#include "engine/core/result.h"
#include "engine/geometry/rigid_transform.h"

#include <string_view>

namespace carina
{

/// A patient made by formulas: mouth with teeth, tongue and palate, pharynx, larynx with vocal
/// cords, epiglottis, trachea with its rings, bronchi to the segments, five lobes, diaphragm, ribs,
/// sternum, clavicles, spine, lower jaw, oesophagus and skin, each closed in each of three levels
/// of detail (whole, a quarter, a sixteenth of the triangles). No file is read; the same build
/// makes the same patient.
///
/// Both lungs together enclose the functional residual capacity, shared as the dimensions say, in
/// every level of detail. What meets itself is made anew, a little finer, up to six times; of the
/// two built-in patients nothing is left that does. Name and content hash say whom these figures
/// make (nameOf, madeHash); with the mouth shut the hash is left empty.
///
/// @returns MeshNotClosed if a surface came out open or inside out; OutOfRange (see dimensionsFor).
[[nodiscard]] Result<Anatomy> patientFor(const PatientParameters& parameters,
                                         Posture posture = Posture::Laryngoscopy);

/// The same with the figures of a built-in patient.
[[nodiscard]] Result<Anatomy> builtinPatient(BuiltinPatient patient);

/// X_AJ of the lower jaw as the surfaces of a patient have it: in those that patientFor makes the
/// mouth is held open, in every other it is shut (the identity).
[[nodiscard]] RigidTransform heldJaw(std::string_view contentHash);

} // namespace carina
