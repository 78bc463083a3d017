#pragma once

#include "engine/anatomy/patient/body_plan.h"
#include "engine/core/result.h"
#include "engine/geometry/rigid_transform.h"

#include <string_view>

namespace carina
{

/// Makes a patient from formulas: mouth with teeth, tongue and palate, pharynx, larynx with vocal
/// cords and hyoid bone, epiglottis, trachea with its rings, bronchi to the segments, five lobes,
/// heart and great vessels, diaphragm, ribs, sternum, clavicles, spine, skull, mandible, oesophagus
/// and skin with a face. Each surface is closed in each of
/// three levels of detail (all, about a quarter and about a sixteenth of the triangles). No file is
/// read; the same build makes the same patient.
///
/// In every level of detail the lungs enclose the functional residual capacity, divided between
/// both sides by rightLungShare. A part that intersects itself is made again with a slightly finer
/// grid, at most six times in all; in the two built-in patients no self-intersection remains. The
/// patient has the name and content hash of its parameters (nameOf, madeHash); in Posture::Rest the
/// hash is empty.
///
/// @returns MeshNotClosed if a surface is open or its volume is not positive; OutOfRange (see
///          dimensionsFor).
[[nodiscard]] Result<Anatomy> patientFor(const PatientParameters& parameters,
                                         Posture posture = Posture::Laryngoscopy);

/// The same for a built-in patient, in Posture::Laryngoscopy.
[[nodiscard]] Result<Anatomy> builtinPatient(BuiltinPatient patient);

/// X_AJ of the mandible in the surfaces of a patient: open in those that patientFor makes in
/// Posture::Laryngoscopy, recognised by their content hash; the identity (closed) in all others.
[[nodiscard]] RigidTransform heldJaw(std::string_view contentHash);

} // namespace carina
