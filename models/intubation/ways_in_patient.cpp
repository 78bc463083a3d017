#include "models/intubation/ways_in_patient.h"

#include "models/patient/laryngoscopy.h"

namespace carina
{
namespace
{

bool tellsWays(PartRole role)
{
    return role == PartRole::RightMainBronchus || role == PartRole::LeftMainBronchus
           || role == PartRole::Oesophagus;
}

std::vector<AnatomyPart> partsOfWays(const PatientModel& patient)
{
    std::vector<AnatomyPart> parts;
    for (const PatientSurface& surface : patient.surfaces()) {
        if (!tellsWays(surface.description.role))
            continue;
        parts.push_back(surface.description);
        parts.back().levels.push_back(*surface.levels.front());
    }
    return parts;
}

} // namespace

PatientWays waysOf(const PatientModel& patient)
{
    const auto laryngoscopy = Laryngoscopy::of(patient, bladeOf(kUsualBlade));
    const auto upper = laryngoscopy ? std::optional{laryngoscopy->script().airway} : std::nullopt;
    return patientWays(patient.landmarks(), upper, partsOfWays(patient));
}

std::vector<Vec3> measuredTube(const PatientModel& patient, const NeckField& neck,
                               const RigidTransform& X_AE)
{
    std::vector<Vec3> line = centreIn(neck, patient.tube());
    for (Vec3& p : line)
        p = X_AE * p;
    return line;
}

} // namespace carina
