#pragma once

#include "engine/core/units.h"
#include "engine/tracking/simulated/simulated_tracker.h"

#include <vector>

namespace carina
{

/// The parameters of a scripted intubation.
struct HandScript {
    RigidTransform X_TA;      ///< pose of the patient in the tracker's frame
    std::vector<Vec3> path_A; ///< of the tip, from some 10 cm before the incisors to the carina
    Vec3 p_A_incisors = Vec3::Zero();
    std::vector<Vec3> p_E_centre;               ///< centreline of the tube, connector to tip
    Length restAboveCarina = metres(0.03);      ///< of the tip along the path, when in place
    Duration period = std::chrono::seconds{20}; ///< common period of all tools
};

/// A scripted intubation that repeats, for a station without a person: the true poses of the five
/// tools, each a pure function of time with one common period.
///
/// E, the tube, is rigid: its tip lies on the path, and its centreline passes through a second
/// point of the path, 4 cm before the tip until that lies at the incisors, and from then on there.
/// Of a tube that is curved so much that it comes nearer to its tip again, the point that lies as
/// far back along it is on the line through both. So the tube enters between the teeth, slides
/// through the mouth as it is inserted, and lies along the path where it has the path's shape.
/// About that line it is rotated so that +x of E points as far to the patient's left (+x of A) as
/// possible. In a period the tube is held outside (10 %), inserted (40 %), left in place (20 %) and
/// withdrawn (30 %). It starts and stops smoothly; the faster of tip and connector determines the
/// speed, also in bends.
///
/// J, the jaw: origin at the chin, axes parallel to A while the mouth is closed. It opens about the
/// transverse axis through the condyles (movedJaw) by 20 degrees while the tube moves, and by 8
/// degrees while it is in place.
///
/// H, the trainee's head: origin at the eyes of a person who stands behind the patient's head; -z
/// of H points at the incisors, +x to the right, +y up (anterior); it sways by 2 cm.
///
/// S, the stylus: parked beside the patient's left cheek, axes parallel to A.
///
/// G, the hand: it holds the tube 3 cm outside its connector and points along it into the patient,
/// with the axes of E.
class ScriptedHands
{
public:
    /// @returns NotFinite for a number that is not finite; OutOfRange where restAboveCarina is
    ///          negative or not shorter than the path, where the path turns back sharply or runs
    ///          along x of A so that the rotation of the tube about it is undetermined, where
    ///          the tube does not reach from its tip on the path out of the mouth or runs along x
    ///          of E, or where the period is not above zero.
    [[nodiscard]] static Result<ScriptedHands> make(HandScript script);

    /// X_T<tool> at time t; nothing for other tools than these five. Usable as a TrueToolPose.
    [[nodiscard]] std::optional<RigidTransform> operator()(ToolRole tool, SessionTime t) const;

    /// X_AJ with the mouth closed.
    [[nodiscard]] RigidTransform closedJaw() const;

private:
    /// A position of the tip on the path, and the distance that the tube has moved to get there.
    struct Waypoint {
        double along = 0.0;  ///< arc length of the path, metres
        double travel = 0.0; ///< metres moved by the faster of tip and connector
    };

    explicit ScriptedHands(HandScript script) : m_script{std::move(script)} {}

    [[nodiscard]] bool layWaypoints(double end);
    [[nodiscard]] double phaseAt(SessionTime t) const;
    [[nodiscard]] Vec3 pathPoint(double along) const;
    [[nodiscard]] std::optional<Vec3> centreAt(double fromTip) const;
    [[nodiscard]] std::optional<Vec3> centreAtDistance(double fromTip) const;
    [[nodiscard]] std::optional<RigidTransform> tubeAlong(double along) const;
    [[nodiscard]] std::optional<RigidTransform> tubeAt(double phase) const;
    [[nodiscard]] RigidTransform jawAt(double phase) const;
    [[nodiscard]] RigidTransform headAt(double phase) const;

    HandScript m_script;
    std::vector<double> m_along; // arc length at each point of the path, metres
    double m_alongAtTeeth = 0.0; // of the point of the path nearest to the incisors
    bool m_turnsBack = false;    // the tube comes nearer to its tip again, away from it along it
    std::vector<Waypoint> m_waypoints;
};

/// X_EG of the hand that holds the tube.
[[nodiscard]] RigidTransform handOnTube();

/// Where the stylus is parked, in A.
[[nodiscard]] Vec3 stylusBesideCheek(const Vec3& p_A_incisors);

/// X_AJ of a mandible whose frame J coincides with A while the mouth is closed: moved forward, and
/// rotated about the transverse axis through the condyles, which lie 88 mm from the incisors, 26
/// degrees above the plane of the teeth (Bonwill's triangle, Balkwill's angle).
/// @param size by which these lengths are multiplied, above 0: less than 1 in who is smaller
[[nodiscard]] RigidTransform movedJaw(const Vec3& p_A_incisors, Angle opening, Length forward = {},
                                      double size = 1.0);

/// X_TA of a patient in front of a tracker that looks at a point before the face from 1.25 m to the
/// left and above. All four tools, with a tube of common size, stay inside the working volume, and
/// so does a stylus that touches the rib cage.
[[nodiscard]] RigidTransform patientBeforeTracker(const Vec3& p_A_incisors);

} // namespace carina
