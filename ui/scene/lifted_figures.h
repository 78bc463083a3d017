#pragma once

#include "models/patient/patient_model.h"
#include "models/station/station_view.h"
#include "widgets/scene/figures/scene_figure.h"
#include "widgets/scene/view/scene_frame.h"

#include <optional>
#include <vector>

namespace carina
{

/// Something that is lifted out, with what is written beside it.
struct DrawnLift {
    ObjectId object;
    std::optional<OrganGroup> group; ///< std::nullopt: the second tube
    QString name;

    friend bool operator==(const DrawnLift&, const DrawnLift&) = default;
};

/// What is lifted out at a moment, of what the patient has.
[[nodiscard]] std::vector<DrawnLift> drawnLifts(const StationMoment& moment,
                                                const PatientModel& patient);

/// Their figures: the name of a group of organs, whose parts are those of the patient; and the
/// second tube.
[[nodiscard]] std::vector<SceneFigure> liftedFigures(const std::vector<DrawnLift>& lifts,
                                                     const PatientModel& patient);

/// Adds to a frame of sceneFrame() what is lifted out at its moment. An object's frame O has its
/// origin in the centre of the group, or of the tube, and the axes of the patient's frame V, or of
/// A. In its place X_VO is a translation; its motion is that of its actions from there:
///
///     p_V = p_VO + p_acted + scale_acted R_acted (p_V_in_place - p_VO)
///
/// so that it goes with a patient that is moved, and is where it was when it is lifted out. The
/// second tube lies beside the patient, as the tube lies in it at its final depth, and is moved
/// in A.
void addLifted(SceneFrame& frame, const StationMoment& moment, const PatientModel& patient);

/// A lifted object in a frame.
struct LiftedInFrame {
    ObjectId object;
    ParticipantId owner;
    std::optional<OrganGroup> group;
    PlacedBody place; ///< of its frame O, as drawn
};

/// What a frame draws lifted out.
[[nodiscard]] std::vector<LiftedInFrame> liftedIn(const SceneFrame& frame,
                                                  const StationMoment& moment);

} // namespace carina
