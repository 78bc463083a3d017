#pragma once

#include "engine/anatomy/body_plan.h"
#include "engine/core/result.h"
#include "engine/geometry/rigid_transform.h"

#include <optional>
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
/// two built-in patients nothing is left that does. The content hash is left empty: who has only a
/// hash could not make the same patient.
///
/// @returns MeshNotClosed if a surface came out open or inside out; OutOfRange (see dimensionsFor).
[[nodiscard]] Result<Anatomy> patientFor(const PatientParameters& parameters,
                                         Posture posture = Posture::Laryngoscopy);

/// The same with the figures of a built-in patient.
[[nodiscard]] Result<Anatomy> builtinPatient(BuiltinPatient patient);

/// X_AJ of the lower jaw as the surfaces of a patient have it: the built-in patients' mouths are
/// held open, every other's is shut (the identity).
[[nodiscard]] RigidTransform heldJaw(std::string_view contentHash);

/// The built-in patient with this content hash; nothing for any other.
[[nodiscard]] std::optional<BuiltinPatient> builtinOfHash(std::string_view contentHash);
/// And back: the name and the version of what makes it.
[[nodiscard]] std::string_view builtinHash(BuiltinPatient patient);

} // namespace carina
