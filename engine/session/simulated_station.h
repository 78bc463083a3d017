#pragma once

#include "engine/anatomy/anatomy.h"
#include "engine/anatomy/shapes/tube.h"
#include "engine/geometry/deformation/neck_field.h"
#include "engine/session/scripted_laryngoscopy.h"
#include "engine/session/station_tracking.h"
#include "engine/tracking/simulated/simulated_tracker.h"

#include <functional>

namespace carina
{

/// A station without hardware. The simulated tracker observes scripted hands that repeatedly insert
/// the tube into this patient, a marker on the chest where the manikin breathes, and the body probe
/// where the registration has one. With a laryngoscope (SimulatedTrackerSettings::laryngoscope) the
/// larynx is shown first, by which the jaw is moved, and the tube comes while the blade is lifted.
struct SimulatedStation {
    std::unique_ptr<StationTracking> tracking;
    RigidTransform X_TA;         ///< the true pose of the anatomy
    StationRegistration exactly; ///< the error-free registration
    TrueToolPose truth;          ///< the true X_T<tool>, without the tracker's errors
};

/// The number of the person whose hands and head are simulated, 0 by default. Each works at another
/// time of the period, and each of five stands at another place around the patient's head, so that
/// several do not coincide; all are in the tracker's view. Called on the tracker's thread.
using SimulatedPerson = std::function<unsigned()>;

/// Where hands hold tube and laryngoscope, and the mandible, in the frame U of the head, which is A
/// while head and neck lie in neutral position; and a stylus, in that of the torso.
struct HandledTools {
    RigidTransform X_UE;                  ///< the tube's connector
    RigidTransform X_UL;                  ///< the blade of the laryngoscope
    RigidTransform X_UJ;                  ///< the mandible, the identity with the mouth shut
    std::optional<RigidTransform> X_AS{}; ///< nothing where it lies beside the patient
};

/// What hands do with them. Called on the tracker's thread.
using HandMotion = std::function<HandledTools(SessionTime)>;

/// How head and neck of the simulated manikin lie now. Called on the tracker's thread.
using SimulatedHead = std::function<HeadPosition()>;

/// @param registration of the manikin; without one the error-free registration is used. If it has
///        X_BA, the manikin wears a body probe, whose true pose is simulatedBodyProbe(); if it has
///        X_NE or X_NL, the markers of tube or laryngoscope are where those of simulatedTools() are
/// @param manikinBreathes breathing rate at which the chest rises by kManikinRise; 0: no breathing
///        and no marker
/// @param device its tracker; which probes there are follows from the other arguments, but for the
///        laryngoscope
/// @param laryngoscopy what is done with a laryngoscope; without it, as in a patient whose larynx
///        is not known, a laryngoscope is never seen
/// @param head neutral without it. The jaw goes with the head, a laryngoscope into the mouth as it
///        lies, and the tube the way of the airway there, with its form where it fits the airway
///        (bent); the tip rests as far above the carina as in neutral position
/// @param motion what tube, jaw, laryngoscope and stylus do in place of all this, whoever the
///        person is; the first three go with the head. The laryngoscope is seen where the device
///        has one
/// @returns the errors of ScriptedHands::make for this airway.
[[nodiscard]] Result<SimulatedStation>
simulatedStation(const AirwayLandmarks& airway, const TubeShape& tube, ReadSessionClock clock,
                 const std::optional<StationRegistration>& registration = {},
                 Frequency manikinBreathes = {}, SimulatedPerson person = {},
                 SimulatedTrackerSettings device = {},
                 const std::optional<LaryngoscopyScript>& laryngoscopy = {},
                 SimulatedHead head = {}, HandMotion motion = {});

inline constexpr Length kManikinRise = millimetres(12.0);

/// X_AB of the body probe of a simulated manikin: on its right shoulder, with the axes of A.
[[nodiscard]] RigidTransform simulatedBodyProbe();

} // namespace carina
