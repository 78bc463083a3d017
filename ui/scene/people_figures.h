#pragma once

#include "models/patient/patient_model.h"
#include "models/station/laryngoscope_sight.h"
#include "models/station/station_view.h"
#include "widgets/scene/figures/scene_figure.h"
#include "widgets/scene/view/scene_frame.h"

#include <optional>
#include <vector>

namespace carina
{

/// An object of a person that a scene draws beside the patient, or whose name it writes.
struct DrawnPerson {
    ObjectId object;
    ParticipantId owner;
    ObjectKind kind = ObjectKind::Head;
    QString name;          ///< written beside it
    bool isAtWork = false; ///< the tube that is drawn with the patient: named only
    bool isOwn = false;    ///< of this program's participant
    BladeForm blade{};     ///< of a laryngoscope

    friend bool operator==(const DrawnPerson&, const DrawnPerson&) = default;
};

/// What is drawn of the people at a moment: heads, hands and styluses of others, and all tubes and
/// laryngoscopes. The own head is never drawn; own hands and the own stylus are for who looks at a
/// screen (StationMoment::ownHandsAreDrawn).
/// @param blades which says what blades laryngoscopes have
[[nodiscard]] std::vector<DrawnPerson> drawnPeople(const StationMoment& moment,
                                                   const StationLaryngoscope& blades);

/// Their figures; tubes are that of the patient.
[[nodiscard]] std::vector<SceneFigure> peopleFigures(const std::vector<DrawnPerson>& people,
                                                     const PatientModel& patient);

/// An object of a person in a frame.
struct ObjectInFrame {
    ObjectId object;
    ParticipantId owner;
    ObjectKind kind = ObjectKind::Head;
    bool isOwn = false;    ///< of this program's participant
    RigidTransform X_AO{}; ///< as drawn; of what is own, where others draw it
};

/// The objects that a frame draws, and besides them those of this program's participant that are
/// tracked, whether they are drawn or not.
[[nodiscard]] std::vector<ObjectInFrame> objectsIn(const SceneFrame& frame,
                                                   const StationMoment& moment);

/// Has the tube that is drawn with the patient and those of others bent as the airway is
/// (bendTube).
void bendTubes(SceneFrame& frame, const StationMoment& moment, const PatientModel& patient);

/// Adds the bodies of the people to a frame, each at its place (PersonPose::X_AO), but for what is
/// of the participant whose view it is, at whose eye nothing is turned; what is lost is not drawn.
/// @param throughEyesOf whose head is the eye of the view and therefore not drawn; by default it is
///                      the view of this program's participant
void addPeople(SceneFrame& frame, const StationMoment& moment,
               const std::optional<ParticipantId>& throughEyesOf = {});

} // namespace carina
