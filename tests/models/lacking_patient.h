#pragma once

#include "engine/anatomy/patient/builtin_patient.h"
#include "engine/anatomy/patient/patient_name.h"
#include "models/patient/patient_source.h"

#include <string>
#include <string_view>
#include <utility>

namespace carina::test
{

/// The built-in child without some parts, as an imported set may be.
/// @param hash of its contents
template <class IsMissing>
SharedPatientModel childWithout(const IsMissing& isMissing, std::string hash)
{
    static const Anatomy whole = builtinPatient(BuiltinPatient::TwelveYears).value();
    Anatomy anatomy = whole;
    std::erase_if(anatomy.parts, isMissing);
    anatomy.contentHash = std::move(hash);
    return patientOf(std::move(anatomy)).value();
}

/// The same without the parts of a role.
inline SharedPatientModel childWithout(PartRole role)
{
    return childWithout([role](const AnatomyPart& part) { return part.role == role; },
                        "without " + std::to_string(static_cast<int>(role)));
}

/// A patient of whom only the landmarks of the airway are known, by which the neck bends.
inline SharedPatientModel landmarksOf(std::string_view words)
{
    const PatientDimensions dimensions = dimensionsFor(patientFromWords(words).value()).value();
    Anatomy anatomy;
    anatomy.landmarks = bodyPlanOf(dimensions, Posture::Laryngoscopy).landmarks;
    anatomy.contentHash = "landmarks of a " + std::string{words};
    return std::make_shared<const PatientModel>(
        PatientModel::of(std::move(anatomy), dimensions.tubeInnerDiameter).value());
}

} // namespace carina::test
