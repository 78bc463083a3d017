#pragma once

#include "models/patient/patient_model.h"
#include "models/station/station_view.h"
#include "widgets/scene/surfaces/scene_part.h"
#include "widgets/scene/view/scene_frame.h"

#include <vector>

namespace carina
{

/// The surfaces of a patient as parts of a scene, in their order; a part's id is its place + 1.
[[nodiscard]] std::vector<ScenePart> sceneParts(const PatientModel& patient);

/// Where the jaw takes a patient's throat at a moment; without a chin probe in view the mouth is
/// drawn as the surfaces have it.
[[nodiscard]] FollowingThroat throatAt(const StationMoment& moment, const PatientModel& patient);

/// A station's moment as a frame of that scene, in which the patient's chest moves by `chest` and
/// what hangs from the jaw by `throat`, without which it stays. What is lost is not drawn; tools
/// stay where they are while the patient is moved by an action.
[[nodiscard]] SceneFrame sceneFrame(const StationMoment& moment, const ChestField& chest,
                                    const FollowingThroat& throat = {});

} // namespace carina
