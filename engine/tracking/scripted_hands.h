#pragma once

#include "engine/core/units.h"
#include "engine/tracking/simulated_tracker.h"

#include <vector>

namespace carina
{

/// What a scripted intubation is made of.
struct HandScript {
    RigidTransform X_TA;      ///< where the patient lies before the tracker
    std::vector<Vec3> path_A; ///< the tip's way, from some 10 cm before the incisors to the carina
    Vec3 p_A_incisors = Vec3::Zero();
    Vec3 p_E_tip = Vec3::Zero();                ///< the tube's tip in its connector's frame
    Vec3 dir_E_tip = -Vec3::UnitZ();            ///< where the tip points, of any length
    Length restAboveCarina = metres(0.03);      ///< of the tip along the path, when in place
    Duration period = std::chrono::seconds{20}; ///< of everything
};

/// A scripted pair of hands that brings a tube in again and again, for a station without a person:
/// the true poses of the four tools, each a pure function of time with one common period.
///
/// E, the tube: its tip lies on the path and points along it, along the chord over 4 cm to either
/// side, so that it is turned smoothly; about that direction the tube is turned so that +x of E
/// points as far to the patient's left (+x of A) as it can. In a period it is held outside (10 %),
/// brought in (40 %), left in place (20 %) and withdrawn (30 %); it starts and stops gently, and
/// the faster of tip and connector sets the pace, so that no bend is taken in a swing.
///
/// J, the jaw: origin at the chin, axes parallel to A while the mouth is closed. It turns about the
/// transverse axis through the condyles (movedJaw) by 20 degrees to let the tube in or out, by 8
/// around the tube in place.
///
/// H, the head: at the eyes of someone who stands behind the patient's head; looks along -z of H at
/// the incisors, +x to its right, +y up (anterior), and sways by 2 cm.
///
/// S, the stylus: parked beside the patient's left cheek, axes parallel to A.
class ScriptedHands
{
public:
    /// @returns NotFinite for a number that is not; OutOfRange where restAboveCarina is negative or
    ///          not shorter than the path, where the path turns back sharply, or runs sideways so
    ///          that the tube's turn about it is undetermined, where dir_E_tip is zero or parallel
    ///          to x of E, or where the period is not above zero.
    [[nodiscard]] static Result<ScriptedHands> make(HandScript script);

    /// X_T<tool> at a time; nothing for tools the hands do not have. Has the form of TrueToolPose.
    [[nodiscard]] std::optional<RigidTransform> operator()(ToolRole tool, SessionTime t) const;

    /// X_AJ with the mouth closed.
    [[nodiscard]] RigidTransform closedJaw() const;

private:
    /// A place of the tip on its way: how far along the path, and how far the hand has come.
    struct Waypoint {
        double along = 0.0;  ///< metres of path
        double travel = 0.0; ///< metres, of the faster of tip and connector
    };

    explicit ScriptedHands(HandScript script) : m_script{std::move(script)} {}

    [[nodiscard]] bool layWaypoints(double end);
    [[nodiscard]] double phaseAt(SessionTime t) const;
    [[nodiscard]] Vec3 pathPoint(double along) const;
    [[nodiscard]] std::optional<RigidTransform> tubeAlong(double along) const;
    [[nodiscard]] std::optional<RigidTransform> tubeAt(double phase) const;
    [[nodiscard]] RigidTransform jawAt(double phase) const;
    [[nodiscard]] RigidTransform headAt(double phase) const;

    HandScript m_script;
    std::vector<double> m_along; // of each point of the path
    std::vector<Waypoint> m_waypoints;
};

/// X_AJ of a mandible that was in place with the mouth closed: brought forward, and turned about
/// the transverse axis through the condyles, which lie 88 mm from the incisors, 26 degrees above
/// the plane of the teeth (Bonwill's triangle, Balkwill's angle).
[[nodiscard]] RigidTransform movedJaw(const Vec3& p_A_incisors, Angle opening, Length forward = {});

/// X_TA of a patient who lies so that a tracker 1.25 m to the left of and above a point before the
/// face looks at that point: all four tools stay inside its working volume with a tube of common
/// size, and so does a stylus that touches the rib cage.
[[nodiscard]] RigidTransform patientBeforeTracker(const Vec3& p_A_incisors);

} // namespace carina
