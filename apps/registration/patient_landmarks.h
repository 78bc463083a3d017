#pragma once

#include "apps/program/options/patient_option.h"
#include "engine/registration/landmarks/landmark_catalogue.h"

#include <vector>

namespace carina
{

/// The landmark sets offered for a patient: eight on rib cage and jaw, the first six of these, and
/// the four of the rib cage. They are on its bones or, for a patient without bones, from the body
/// proportions for its height.
[[nodiscard]] std::vector<LandmarkCatalogue> landmarkSetsOf(const program::ChosenPatient& patient);

/// Points on its bones for verifying a registration, none of them a landmark.
[[nodiscard]] std::vector<Landmark> checkPlacesOf(const program::ChosenPatient& patient);

} // namespace carina
