#pragma once

#include "engine/tracking/igtl/igtl_subscriber.h"
#include "models/patient/patient_model.h"
#include "models/station/station_view.h"

namespace carina
{

/// X_RA of the frame R of 3D Slicer: A with its first two axes reversed, so that +x is the
/// patient's right, +y anterior, +z superior.
[[nodiscard]] RigidTransform axesOfSlicer();

/// What a station shows at a moment, for programs of other makers, in the frame R:
///
/// - the tools "Tube" and "Jaw" of who is at work, and of everyone who is there "Head", "Hand",
///   "Stylus" and "Blade" (the laryngoscope), each with a blank and the person's name; names end
///   after 20 characters;
/// - the landmarks of the airway where head and neck have taken them, as fiducials of the group
///   "Landmark";
/// - the surface of the lungs as it is drawn, in its coarsest level of detail, at most ten times a
///   second.
class StationOffer
{
public:
    /// The level of detail of the lungs that is offered; the moment has the pose of the chest for
    /// it.
    [[nodiscard]] static std::size_t levelOf(const PatientModel& patient);

    /// @param patient that the moment is of
    /// @param since1970 (UTC) of the moment
    [[nodiscard]] std::shared_ptr<const IgtlOffer>
    at(const PatientModel& patient, const StationMoment& moment, Duration since1970);

private:
    std::string m_patient;   ///< content hash of the one that the following are of
    HeadPosition m_position; ///< in which the landmarks are
    std::shared_ptr<const IgtlPoints> m_landmarks;
    std::shared_ptr<const IgtlOffer::Surface> m_lungs;
    Duration m_lungsMade{}; ///< since 1970
};

} // namespace carina
