#pragma once

#include "apps/program/seen_overlay.h"
#include "engine/net/node/session_node.h"
#include "engine/session/station_tracking.h"
#include "models/patient/patient_source.h"
#include "models/respiration/manikin_breaths.h"
#include "models/site/site_setup.h"
#include "models/station/chin_probe_model.h"
#include "models/station/station_view.h"

#include <QTimer>

#include <atomic>

namespace carina
{

/// A trainee's part in a session: the node, and the patient that lies at the station now with
/// everything that depends on it. Another patient can be laid while the session goes on.
class TraineeStation
{
public:
    /// What the site says of a patient; without it, the manikin is registered exactly.
    using Place = std::optional<SiteSetup>;
    using PlaceOf = std::function<Result<Place>(const PatientModel&)>;

    /// What stands in for hardware.
    struct Simulation {
        bool tracker = false;      ///< a simulated tracker and hands; without them it watches
        Frequency manikinBreathes; ///< 0: it lies still
    };

    TraineeStation(std::unique_ptr<SessionNode> node, StationId station,
                   const Simulation& simulation, PlaceOf placeOf);
    ~TraineeStation();
    TraineeStation(const TraineeStation&) = delete;
    TraineeStation& operator=(const TraineeStation&) = delete;

    /// Lays a patient in place of the one before. @param show turns to what is new here, while what
    /// was before still is
    /// @returns what its site, or the simulated tracker, says against it; nothing is changed then.
    [[nodiscard]] Result<void> lay(const SharedPatientModel& patient,
                                   const std::function<void()>& show = {});
    /// Takes over what the site says now; as before where it says nothing that can be used.
    void takePlace();
    /// Called after another patient was laid.
    void onLaid(std::function<void()> callback) { m_onLaid = std::move(callback); }

    [[nodiscard]] SessionNode& node() { return *m_node; }
    // @pre a patient was laid. They are good until the next one is.
    [[nodiscard]] const StationView& view() const { return *m_laid->view; }
    [[nodiscard]] ChinProbeModel chinProbe() const
    {
        return ChinProbeModel{m_laid->tracking.get(), &m_laid->guard};
    }
    /// What the simulated head truly has before it; empty without one.
    [[nodiscard]] const program::TrueView& truth() const { return m_laid->truth; }

private:
    struct Laid {
        SharedPatientModel patient;
        /// Shared with the node's thread while it asks for poses; none where this only watches.
        std::shared_ptr<StationTracking> tracking;
        program::TrueView truth;
        std::unique_ptr<StationView> view;
        std::unique_ptr<RegistrationGuard> guard; ///< of the tracking; none without a site
        Place place;                              ///< as the site said last
    };

    [[nodiscard]] Result<void> watchHands(Laid& laid);
    void publish();

    std::unique_ptr<SessionNode> m_node;
    StationId m_station;
    Simulation m_simulation;
    PlaceOf m_placeOf;
    std::function<void()> m_onLaid;
    std::unique_ptr<Laid> m_laid;
    std::atomic<std::shared_ptr<StationTracking>> m_published;
    QTimer m_looking;                          ///< of the guard
    std::unique_ptr<ManikinBreaths> m_manikin; ///< last: asks what is above
};

} // namespace carina
