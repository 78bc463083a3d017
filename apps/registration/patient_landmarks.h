#pragma once

#include "apps/program/patient_option.h"
#include "engine/registration/landmarks/landmark_catalogue.h"

#include <vector>

namespace carina
{

/// The landmarks offered for a patient, on its bones where it has them and by the proportions of a
/// body of its height where not: eight on rib cage and jaw, the first six of these, and the four of
/// the rib cage.
[[nodiscard]] std::vector<LandmarkCatalogue> landmarkSetsOf(const program::ChosenPatient& patient);

/// Places of its bones to check a registration at, none of them a landmark.
[[nodiscard]] std::vector<Landmark> checkPlacesOf(const program::ChosenPatient& patient);

} // namespace carina
