#pragma once

#include "models/respiration/manikin_breaths.h"
#include "models/station/shared_tools.h"
#include "models/station/station_view.h"

namespace carina
{

/// A trainee's station in a session: the node, the tools of the tracker, and the view of the
/// present patient. The patient can be replaced during the session.
class TraineeStation
{
public:
    TraineeStation(std::unique_ptr<SessionNode> node, SharedTools::Hardware hardware,
                   SharedTools::PlaceOf placeOf);

    /// Shows another station of the session from now on.
    void setStation(StationId station);
    /// The callback is called with another patient or tracker in place, while the objects of the
    /// former one still exist.
    void onShown(std::function<void()> callback) { m_onShown.push_back(std::move(callback)); }

    [[nodiscard]] SessionNode& node() { return *m_node; }
    [[nodiscard]] const SessionNode& node() const { return *m_node; }
    /// By which the patient is laid.
    [[nodiscard]] SharedTools& tools() { return m_tools; }
    [[nodiscard]] const SharedTools& tools() const { return m_tools; }
    // @pre a patient was laid. Results are valid until the next one is.
    [[nodiscard]] const StationView& view() const { return *m_view; }
    /// With the tube of the site, where that is calibrated.
    [[nodiscard]] const PatientModel& patient() const { return *m_tools.patient(); }

private:
    void showAnew();

    std::unique_ptr<SessionNode> m_node;
    StationId m_station; ///< where this participant is
    SharedTools m_tools;
    std::unique_ptr<StationView> m_view;
    std::unique_ptr<ManikinBreaths> m_manikin; ///< from the first tracker on
    std::vector<std::function<void()>> m_onShown;
};

} // namespace carina
