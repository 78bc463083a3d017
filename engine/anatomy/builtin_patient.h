#pragma once

#include "engine/anatomy/anatomy.h"
#include "engine/anatomy/patient_dimensions.h"
#include "engine/core/result.h"

#include <optional>
#include <string_view>

namespace carina
{

/// A patient made from its dimensions: trachea, main bronchi with their lobar branches, larynx,
/// epiglottis, both lungs and mandible, each closed in each of three levels of detail (whole, a
/// quarter, a sixteenth of the triangles). No file is read; the same build makes the same patient.
///
/// Both lungs together enclose the functional residual capacity, shared as the dimensions say, in
/// every level of detail.
///
/// @returns MeshNotClosed if a surface came out open or inside out.
[[nodiscard]] Result<Anatomy> builtinPatient(BuiltinPatient patient);

/// The built-in patient with this content hash; nothing for any other.
[[nodiscard]] std::optional<BuiltinPatient> builtinOfHash(std::string_view contentHash);

} // namespace carina
