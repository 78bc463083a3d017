#pragma once

#include "models/patient/session_patient.h"
#include "models/station/station_view.h"

#include <functional>
#include <memory>

namespace carina
{

/// The station that the console shows: its patient, and the view of it. The view goes to another
/// station at once where the same patient lies, else when its patient is available.
class ShownStation
{
public:
    /// @param first is shown until the station's patient is available
    /// @param own poses of this program's objects
    /// @pre node outlives this.
    ShownStation(SessionNode& node, StationId station, SharedPatientModel first, ObjectPoses own);

    void setStation(StationId station);
    /// The callback is called with a new patient and view in place, while the former ones still
    /// exist.
    void onShown(std::function<void(const PatientModel&, StationView&)> callback);

    [[nodiscard]] SessionPatient& patient() { return m_patient; }
    /// Valid until the callback has returned.
    [[nodiscard]] StationView& view() { return *m_view; }

private:
    [[nodiscard]] bool isDrawn() const;

    SessionNode& m_node;
    StationId m_station;
    SessionPatient m_patient;
    ObjectPoses m_own;
    std::unique_ptr<StationView> m_view;
};

} // namespace carina
