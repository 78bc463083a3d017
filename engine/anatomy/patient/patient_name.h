#pragma once

#include "engine/anatomy/patient/patient_dimensions.h"

#include <optional>
#include <string>
#include <string_view>

namespace carina
{

/// Whom these words mean: "adult" and "child", the built-in patients, or figures in any order with
/// commas between them, such as "45 years, 182 cm, man" or "8y, 128cm, girl, slim": whole years and
/// centimetres, man, boy, woman or girl, and slim or obese where that is so.
/// @returns OutOfRange for other words, for an age, height or sex that is missing or there twice,
///          and for figures that dimensionsFor refuses. The detail says what is asked for; capitals
///          do not matter.
[[nodiscard]] Result<PatientParameters> patientFromWords(std::string_view words);

/// "Adult", "12 years, 150 cm", "45 years, 162 cm, woman, obese".
[[nodiscard]] std::string nameOf(const PatientParameters& parameters);

/// The content hash of the patient that these figures make (see patientFor): the figures, in whole
/// years and centimetres, and the version of what makes it.
[[nodiscard]] std::string madeHash(const PatientParameters& parameters);

/// And back; nothing for any other text.
[[nodiscard]] std::optional<PatientParameters> parametersOfHash(std::string_view contentHash);

} // namespace carina
