#pragma once

#include "engine/net/node/session_node.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace carina
{

/// The source of the poses of a program's own objects, in A; by default it has none.
struct ObjectPoses {
    /// The pose at a time; std::nullopt for an object never seen.
    std::function<std::optional<PoseSample>(ObjectKind, SessionTime)> at =
        [](ObjectKind, SessionTime) { return std::nullopt; };
    /// The time of the newest sample.
    std::function<std::optional<SessionTime>(ObjectKind)> newest = [](ObjectKind) {
        return std::nullopt;
    };
    /// Whether an own object is what was shared under this name: a tool can have been shared under
    /// several, of which the last counts.
    std::function<bool(ObjectKind, const std::string& name)> isCalled =
        [](ObjectKind, const std::string&) { return true; };
    /// Whether there is a tool for it, seen or not.
    std::function<bool(ObjectKind)> hasTool = [](ObjectKind) { return false; };
    /// Whether own hands and the own stylus are drawn for a person who looks at a screen. A scene
    /// that is shown in a headset never draws them (StationScene): they are seen anyway.
    bool handsAreDrawn = false;
};

/// An object that a person at a station shares: a head, a hand, a stylus, a
/// laryngoscope, a jaw or a tube.
struct PersonPose {
    ObjectId object;
    ParticipantId owner;
    std::string ownerName;
    std::string name{}; ///< as it was shared: of a laryngoscope it can tell the blade
    ObjectKind kind = ObjectKind::Head;
    bool isOwn = false;    ///< of this program's participant
    bool isAtWork = false; ///< the tube or the jaw of who is at work
    PoseSample pose;       ///< X_AO as its owner has it
    RigidTransform X_AO;   ///< where others see it: at the place that was chosen for its owner
};

/// The objects of the people who are present at a station, at a session time, by object; those
/// never seen are left out. Owner and kind of an object follow from facts alone.
///
/// Head and hands are drawn at the place of their owner (PlaceChosen), and so is a tube or stylus
/// in these hands. The tube of who is at work is where the patient's airway has it, and the hand
/// that holds it and the laryngoscope are with it.
/// @param own poses of this program's objects
[[nodiscard]] std::vector<PersonPose> peoplePoses(const SessionNode& node, StationId station,
                                                  const ObjectPoses& own, SessionTime t);

/// The object at work of this kind, a tube or a jaw; nullptr without one.
[[nodiscard]] const PersonPose* atWork(const std::vector<PersonPose>& people, ObjectKind kind);

/// The head of a participant; nullptr while it was never seen.
[[nodiscard]] const PersonPose* headOf(const std::vector<PersonPose>& people,
                                       ParticipantId participant);

/// X_A'A of a place that is turned by an angle: about +y of A, through its origin.
[[nodiscard]] RigidTransform placedBy(Angle turn);

} // namespace carina
