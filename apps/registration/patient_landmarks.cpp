#include "apps/registration/patient_landmarks.h"

#include "engine/anatomy/builtin_patient.h"
#include "engine/registration/bone_landmarks.h"

namespace carina
{
namespace
{

/// Bones as they lie with the mouth shut: the built-in patients' lower jaws are held open.
std::vector<Bone> bonesOf(const PatientModel& patient)
{
    const bool isShut = !builtinOfHash(patient.contentHash());
    std::vector<Bone> bones;
    for (const PatientSurface& surface : patient.surfaces()) {
        const PartRole role = surface.description.role;
        if (role == PartRole::Rib || (role == PartRole::Mandible && isShut))
            bones.push_back({surface.name, surface.levels.front()->positions});
    }
    return bones;
}

LandmarkCatalogue firstOf(LandmarkCatalogue catalogue, std::size_t count)
{
    catalogue.landmarks.resize(count);
    return catalogue;
}

} // namespace

std::vector<LandmarkCatalogue> landmarkSetsOf(const viewer::ChosenPatient& patient)
{
    const std::string& anatomy = patient.model->contentHash();
    const Length height = patient.dimensions.height;
    const std::vector<Bone> bones = bonesOf(*patient.model);
    const LandmarkCatalogue four =
        boneLandmarks(bones, anatomy).value_or(ribCageCatalogue(height, anatomy));
    const LandmarkCatalogue eight =
        ribCageAndJawCatalogue(four, onBones(furtherPlaces(height), bones));
    return {eight, firstOf(eight, 6), four};
}

std::vector<Landmark> checkPlacesOf(const viewer::ChosenPatient& patient)
{
    return boneCheckPlaces(bonesOf(*patient.model));
}

} // namespace carina
