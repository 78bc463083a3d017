#include "apps/registration/patient_landmarks.h"

#include "engine/registration/bone_landmarks.h"

namespace carina
{

LandmarkCatalogue landmarksOf(const viewer::ChosenPatient& patient)
{
    std::vector<Bone> bones;
    for (const PatientSurface& surface : patient.model->surfaces())
        if (surface.description.role == PartRole::Rib)
            bones.push_back({surface.name, surface.levels.front()->positions});
    const std::string& anatomy = patient.model->contentHash();
    return boneLandmarks(bones, anatomy)
        .value_or(ribCageCatalogue(patient.dimensions.height, anatomy));
}

} // namespace carina
