#pragma once

#include "models/patient/session_patient.h"
#include "models/station/shared_tools.h"
#include "models/station/station_view.h"

#include <functional>
#include <memory>

namespace carina
{

/// The station that the console shows: its patient, the view of it, and the console's own tools at
/// it. The view goes to another station at once where the same patient lies, else when its patient
/// is available.
class ShownStation
{
public:
    /// @param first is shown until the station's patient is available
    /// @param pointer poses of what is pointed with in the picture
    /// @pre node and tools outlive this; nothing was laid.
    ShownStation(SessionNode& node, StationId station, const SharedPatientModel& first,
                 const ObjectPoses& pointer, SharedTools& tools);

    void setStation(StationId station);
    /// The callback is called with a new patient and view in place, while the former ones still
    /// exist.
    void onShown(std::function<void(const PatientModel&, StationView&)> callback);

    [[nodiscard]] SessionPatient& patient() { return m_patient; }
    /// The patient as it is drawn, with the tube of the tools' site. Valid, as view() is, until the
    /// callback has returned.
    [[nodiscard]] const PatientModel& drawn() const { return *m_drawn; }
    [[nodiscard]] StationView& view() { return *m_view; }

private:
    void lay(const SharedPatientModel& patient);
    void showAnew();
    [[nodiscard]] bool isDrawn() const;

    SessionNode& m_node;
    StationId m_station;
    StationId m_drawnAt; ///< the station of the view, until the patient of another is available
    SessionPatient m_patient;
    SharedTools& m_tools;
    ObjectPoses m_own;
    std::function<void(const PatientModel&, StationView&)> m_onShown;
    SharedPatientModel m_drawn;
    std::unique_ptr<StationView> m_view;
};

} // namespace carina
