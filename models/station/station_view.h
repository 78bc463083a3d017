#pragma once

#include "engine/geometry/deformation/neck_field.h"
#include "engine/lungs/mechanics/lung_pair.h"
#include "engine/net/node/session_node.h"
#include "engine/session/respiration/respiration_follower.h"
#include "models/patient/patient_model.h"
#include "models/station/lifted_objects.h"
#include "models/station/people_poses.h"
#include "models/station/tube_drawing.h"

#include <memory>
#include <optional>

namespace carina
{

/// The state of everything that moves at a station, at one session time.
struct StationMoment {
    SessionTime time{};
    ChestShape breathing;                 ///< from the respiratory mechanics
    BodyPosition position{};              ///< how the patient lies or sits
    std::optional<double> inspiration;    ///< RespiratoryFold::inspiration
    AirwayEvents airwayEvents;            ///< what makes the airway difficult, as severe as it is
    ChestPose pose;                       ///< the pose of the chest that shows `breathing`
    Volume notDrawn{};                    ///< volume of the lungs that the pose cannot show
    double exaggeration = 1.0;            ///< of the pose; unless 1, the drawn volumes are not true
    std::optional<PoseSample> tube;       ///< X_AE of who is at work; empty if never seen
    std::optional<PoseSample> jaw;        ///< X_AJ of who is at work, with the head
    HeadPosition headPosition;            ///< how head and neck of patient and manikin lie
    std::optional<PoseSample> head;       ///< X_AH of this program's participant
    bool headIsAwaited = false;           ///< a tracker here has a tool for the head, seen or not
    Angle turn{};                         ///< of the place chosen for this program's participant
    ParticipantId worker = kNobody;       ///< who is at work
    std::vector<PersonPose> people;       ///< what all who are there share, this program's included
    bool ownHandsAreDrawn = false;        ///< and the own stylus: see ObjectPoses
    std::optional<ShownLesson> lesson;    ///< shown to this program's participant
    std::optional<PoseSample> lessonView; ///< X_AD of who shows it, while that is known
    std::optional<ShownObject> patient;   ///< X_AV; empty before any action on the patient
    std::vector<LiftedObject> lifted;     ///< what is not in its place
    std::optional<Duration> sampleAge;    ///< of the tube's newest sample at `time`
    /// The poses of the tube at work, of another; null of an own one.
    std::shared_ptr<const RemoteObject> tubePoses;
    /// How that bends, as its owner has it; nothing where it is not told.
    std::optional<ShapeBetween> tubeShape;
    bool isCuffInflated = false; ///< of the tube in the patient
    bool tubeIsApart = false;    ///< from where it was measured, as it is noted in the session
    TubeDrawing tubeDrawing = TubeDrawing::AsMeasured; ///< set by who draws it
};

/// The events of a patient's airway at a time: those that are decided, but of Swallowing as much as
/// the swallow of then has come to (swallowAt) and drugs leave of it, 0 between swallows; and a
/// laryngospasm that is at least as severe as that by which the patient answers blade or tube.
/// @param run of the patient, at that time
[[nodiscard]] AirwayEvents airwayEventsAt(const Station& station, const PatientRun& run,
                                          SessionTime t);

/// Whether the virtual patient is displaced from its original pose.
[[nodiscard]] bool isAway(const StationMoment& moment);

/// What the chin probe of who is at work tells of the jaw.
enum class JawSight : std::uint8_t {
    NoProbe, ///< none was ever seen
    Lost,    ///< it is not seen
    Astray,  ///< it is where no jaw can be (PatientModel::reachesJaw)
    Seen,
};
[[nodiscard]] JawSight jawSightAt(const StationMoment& moment, const PatientModel& patient);

/// The deformation of a patient's throat by head, neck and jaw at a moment; while the jaw is not
/// Seen, the mouth is drawn as in the surfaces. Either way it opens no farther than events let
/// it. The probe is on a manikin whose head lies as that of the patient.
[[nodiscard]] FollowingThroat throatAt(const StationMoment& moment, const PatientModel& patient);

/// The state of a station as drawn by a viewer: a pure function of facts, poses, actions and time.
/// Must be called from one thread only.
class StationView
{
public:
    /// @param own poses of this program's objects. Before the host has admitted it they are the
    ///            ones at work.
    /// @pre all three outlive the view.
    StationView(const SessionNode& node, StationId station, const LungPair& lungs,
                ObjectPoses own = {});

    /// Shows another station from now on, with the same patient.
    void setStation(StationId station);

    /// Multiplies the motion of the chest from rest, within its range; 1 by default. The drawn
    /// volumes are then not the patient's, and the view must say so.
    void exaggerate(double factor) { m_exaggeration = factor; }

    /// The station at a time, with the pose of the chest for one level of detail.
    [[nodiscard]] StationMoment at(SessionTime t, std::size_t level) const;

    /// The station at the time a frame is lit, on this machine's clock. Before the session clock is
    /// synchronised: the patient at rest and no objects.
    [[nodiscard]] StationMoment litAt(LocalTime lit, std::size_t level) const;

private:
    void addPeople(StationMoment& moment, const SessionState& state) const;
    void addLesson(StationMoment& moment, const SessionState& state) const;

    const SessionNode& m_node;
    StationId m_station;
    const LungPair& m_lungs;
    ObjectPoses m_own;
    double m_exaggeration = 1.0;
    mutable RespirationFollower m_breathing; ///< a cache
};

} // namespace carina
