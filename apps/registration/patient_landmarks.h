#pragma once

#include "apps/viewer/patient_option.h"
#include "engine/registration/landmark_catalogue.h"

namespace carina
{

/// The landmarks offered for a patient: those on its bones, or, for a patient without all of these
/// bones, those of a rib cage of its height.
[[nodiscard]] LandmarkCatalogue landmarksOf(const viewer::ChosenPatient& patient);

} // namespace carina
