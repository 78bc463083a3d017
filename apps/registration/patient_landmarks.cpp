#include "apps/registration/patient_landmarks.h"

#include "engine/registration/landmarks/bone_landmarks.h"

namespace carina
{
namespace
{

/// Bones and cartilages as they lie with the mouth shut.
struct ShutBones {
    std::vector<std::shared_ptr<const TriangleMesh>> meshes;
    std::vector<Bone> bones; ///< of these meshes
};

ShutBones bonesOf(const PatientModel& patient)
{
    ShutBones found;
    for (const PatientSurface& surface : patient.surfaces()) {
        const PartRole role = surface.description.role;
        if (role != PartRole::Rib && role != PartRole::Mandible && role != PartRole::Larynx
            && role != PartRole::Hyoid)
            continue;
        found.meshes.push_back(patient.shutMesh(surface));
        found.bones.push_back({surface.name, found.meshes.back()->positions});
    }
    return found;
}

LandmarkCatalogue firstOf(LandmarkCatalogue catalogue, std::size_t count)
{
    catalogue.landmarks.resize(count);
    return catalogue;
}

} // namespace

std::vector<LandmarkCatalogue> landmarkSetsOf(const program::ChosenPatient& patient)
{
    const std::string& anatomy = patient.model->contentHash();
    const Length height = patient.dimensions.height;
    const auto [meshes, bones] = bonesOf(*patient.model);
    const LandmarkCatalogue four =
        boneLandmarks(bones, anatomy).value_or(ribCageCatalogue(height, anatomy));
    const LandmarkCatalogue eight =
        ribCageAndJawCatalogue(four, onBones(furtherPlaces(height), bones));
    return {eight, firstOf(eight, 6), four};
}

std::vector<Landmark> checkPlacesOf(const program::ChosenPatient& patient)
{
    return boneCheckPlaces(bonesOf(*patient.model).bones);
}

} // namespace carina
