#pragma once

#include "models/patient/patient_model.h"
#include "models/station/station_view.h"
#include "widgets/scene/figures/scene_figure.h"
#include "widgets/scene/surfaces/scene_part.h"
#include "widgets/scene/view/scene_frame.h"

#include <cstdint>
#include <string>
#include <vector>

namespace carina
{

/// The body of all surfaces of a patient but the mandible's.
inline constexpr const char* kPatientBody = "patient";
/// The body of the tube that is drawn with the patient.
inline constexpr const char* kTubeBody = "tube";
/// That of its cuff while it is inflated.
inline constexpr const char* kCuffBody = "cuff";

/// The surfaces of a patient as parts of a scene, in their order; a part's id is its index + 1.
[[nodiscard]] std::vector<ScenePart> sceneParts(const PatientModel& patient);

/// Parts of another tube like that of the patient, as a body of this name, with ids from this on.
[[nodiscard]] std::vector<ScenePart> tubeParts(const PatientModel& patient, const std::string& body,
                                               std::uint16_t firstId);

/// Has a body of tubeParts, or that of the patient's tube, bent by head and neck as the airway is
/// whose form the tube has; one that was touched keeps its form. For one that lies in no lumen.
void bendTube(SceneFrame& frame, const PatientModel& patient, const std::string& body = kTubeBody);

/// The tube as its tracked pose has it, where it is drawn otherwise: a faint outline.
[[nodiscard]] SceneFigure measuredTubeFigure(const PatientModel& patient);
/// Places it. @pre the frame has the body of the tube that is drawn with the patient
void addMeasuredTube(SceneFrame& frame, const PatientModel& patient);

/// The frame of that scene for a station's moment: the patient's chest is deformed by `chest`, neck
/// and tissue around the jaw by `throat` (by default not at all). A lost body is not drawn. An
/// action that moves the patient does not move the tools.
[[nodiscard]] SceneFrame sceneFrame(const StationMoment& moment, const ChestField& chest,
                                    const FollowingThroat& throat = {});

} // namespace carina
