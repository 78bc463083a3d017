#pragma once

#include "engine/anatomy/patient/patient_dimensions.h"

#include <optional>
#include <string>
#include <string_view>

namespace carina
{

/// Parses the description of a patient: comma-separated values in any order, such as "45 years, 182
/// cm, man", "8y, 128cm, girl, slim", "3 months, 60 cm, boy" or "newborn, 50 cm, girl": age in
/// whole years, or below six years in whole months, height in whole centimetres, the sex as man,
/// boy, woman or girl, and optionally slim or obese, and "airway 245 mm" (or "245 mm"), the length
/// from teeth to carina. "adult" or "child" stands for age, height and sex of a built-in patient;
/// another sex may be given beside it ("child, girl"). Case is ignored.
/// @returns OutOfRange for other words, for an age, height or sex that is missing or occurs twice,
///          and for values that dimensionsFor refuses. The detail describes the expected form.
[[nodiscard]] Result<PatientParameters> patientFromWords(std::string_view words);

/// The same whether or not the values are within their ranges.
[[nodiscard]] Result<PatientParameters> parametersFromWords(std::string_view words);

/// "Adult", "12 years, 150 cm, boy", "45 years, 162 cm, woman, obese, airway 230 mm"; "newborn, 50
/// cm, girl", "18 months, 80 cm, boy", "2 years, 86 cm, boy". patientFromWords reads it.
[[nodiscard]] std::string nameOf(const PatientParameters& parameters);

/// The content hash of the patient that patientFor makes from these parameters: the parameters, in
/// whole years (or, of a young child, months), centimetres and millimetres, and the version of the
/// formulas.
[[nodiscard]] std::string madeHash(const PatientParameters& parameters);

/// The inverse of madeHash; nothing for any other text.
[[nodiscard]] std::optional<PatientParameters> parametersOfHash(std::string_view contentHash);

} // namespace carina
