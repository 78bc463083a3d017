#pragma once

#include "engine/anatomy/patient/builtin_patient.h"
#include "models/patient/patient_source.h"

namespace carina::test
{

/// The built-in child without the parts of a role, as an imported set may be.
inline SharedPatientModel childWithout(PartRole role)
{
    Anatomy anatomy = builtinPatient(BuiltinPatient::TwelveYears).value();
    std::erase_if(anatomy.parts, [role](const AnatomyPart& part) { return part.role == role; });
    anatomy.contentHash = "without " + std::to_string(static_cast<int>(role));
    return patientOf(std::move(anatomy)).value();
}

} // namespace carina::test
