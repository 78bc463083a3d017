#pragma once

#include "apps/program/seen_overlay.h"
#include "engine/net/node/session_node.h"
#include "engine/session/station_tracking.h"
#include "models/patient/patient_source.h"
#include "models/respiration/manikin_breaths.h"
#include "models/site/site_setup.h"
#include "models/station/chin_probe_model.h"
#include "models/station/standing_report.h"
#include "models/station/station_view.h"
#include "models/station/tool_status.h"
#include "models/tracker/tracker_choice.h"

#include <QTimer>

#include <atomic>

namespace carina
{

/// A trainee's station in a session: the node, and the present patient with all objects that depend
/// on it. The patient can be replaced during the session.
class TraineeStation
{
public:
    /// The site as of now, for a patient; std::nullopt: the simulated manikin is registered without
    /// error.
    using Place = std::optional<SitePlace>;
    using PlaceOf = std::function<Result<Place>(const PatientModel&)>;

    struct Hardware {
        /// One that is not simulated needs a Place.
        std::optional<TrackerChoice> tracker{};
        Frequency manikinBreathes; ///< the simulated manikin; 0: it lies still
        PoseTreatment treatment{}; ///< of the tracker's poses
    };

    TraineeStation(std::unique_ptr<SessionNode> node, Hardware hardware, PlaceOf placeOf);
    ~TraineeStation();
    TraineeStation(const TraineeStation&) = delete;
    TraineeStation& operator=(const TraineeStation&) = delete;

    /// Shows another station of the session from now on.
    void setStation(StationId station);
    /// Replaces the patient; a tracker that is not simulated goes on. While its site has no
    /// registration that can be used, the station shows what others share, as a program without a
    /// tracker does.
    /// @param show is called with the new patient in place, while the objects of the former one
    ///             still exist
    /// @returns the error of its site or of the tracker; nothing is changed then.
    [[nodiscard]] Result<void> lay(const SharedPatientModel& patient,
                                   const std::function<void()>& show = {});
    /// Applies the present site; of one that cannot be used only the standing, and of a file that
    /// cannot be read that there is none.
    /// @param show as in lay(): with its first registration the patient is laid anew
    void takePlace(const std::function<void()>& show);
    /// Works with another tracker from now on, or with none; the patient is laid anew.
    /// @param show as in lay()
    /// @returns the errors of lay(); NotRegistered for one that is not simulated where there is no
    ///          site. The tracker before is used on then.
    [[nodiscard]] Result<void> setTracker(std::optional<TrackerChoice> tracker,
                                          const std::function<void()>& show);
    /// Lets go of the device of its tracker, or uses it again: its tools are lost meanwhile. No
    /// effect on a tracker without a device.
    void holdTracker(bool holds);
    /// The callback is called after each successful lay().
    void onLaid(std::function<void()> callback) { m_onLaid.push_back(std::move(callback)); }

    [[nodiscard]] SessionNode& node() { return *m_node; }
    // @pre lay() succeeded. Results are valid until the next lay().
    [[nodiscard]] const StationView& view() const { return *m_laid->view; }
    /// With the tube of the site, where that is calibrated.
    [[nodiscard]] const PatientModel& patient() const { return *m_laid->patient; }
    /// The shape of the laryngoscope, where the site has it calibrated.
    [[nodiscard]] std::optional<BladeShape> blade() const;
    /// Null without a tracker, and while the site has no registration that can be used.
    [[nodiscard]] std::shared_ptr<const StationTracking> tracking() const
    {
        return m_laid->tracking;
    }
    [[nodiscard]] ChinProbeModel chinProbe() const
    {
        return ChinProbeModel{m_laid->tracking.get()};
    }
    /// How far the registration can be relied on; std::nullopt without a tracker.
    [[nodiscard]] std::optional<RegistrationStanding> standing() const;
    /// How the tracker sees its tools now; std::nullopt without a tracker.
    [[nodiscard]] std::optional<TrackerSight> trackerSight() const;
    /// Has the tracker's poses predicted or not, and smoothed, also those of the next patient.
    void treat(const PoseTreatment& treatment);
    /// The one that it works with now; nothing without one.
    [[nodiscard]] const std::optional<TrackerChoice>& tracker() const { return m_hardware.tracker; }
    [[nodiscard]] const PoseTreatment& treatment() const { return m_hardware.treatment; }
    /// The true X_HA of the simulated head; empty without a simulation.
    [[nodiscard]] const program::TrueView& truth() const { return m_laid->truth; }

private:
    struct Laid {
        SharedPatientModel given;   ///< as the session has it
        SharedPatientModel patient; ///< with the tube of the site
        /// Shared with the node's thread, which reads poses; null without a tracker, and while the
        /// site has no registration that can be used.
        std::shared_ptr<StationTracking> tracking;
        program::TrueView truth;
        std::unique_ptr<StationView> view;
        std::unique_ptr<RegistrationGuard> guard; ///< of the tracking; null without a site
        Place place;                              ///< as read from the site last
    };

    /// What the node's thread reads poses from.
    struct Published {
        std::shared_ptr<StationTracking> tracking;
        /// The stylus's tip P, with -z ahead along the shaft, in the frame of its markers; nothing
        /// where it is not calibrated.
        std::optional<RigidTransform> X_SP;

        [[nodiscard]] std::optional<PoseSample> newest(ToolRole tool) const;
    };
    void publishPoses();

    [[nodiscard]] Result<void> track(Laid& laid);
    [[nodiscard]] Result<void> simulate(Laid& laid) const;
    [[nodiscard]] Result<void> connect(Laid& laid) const;
    [[nodiscard]] bool isTracking(const Tracker& tracker) const;
    void publish();
    void share(ObjectKind kind, ToolRole tool, std::string name);
    void shareLaryngoscope();

    std::unique_ptr<SessionNode> m_node;
    StationId m_station; ///< where this participant is
    Hardware m_hardware;
    PlaceOf m_placeOf;
    std::vector<std::function<void()>> m_onLaid;
    std::unique_ptr<Laid> m_laid;
    /// Of m_hardware.tracker, shared with m_laid: it runs on for another patient. Null before it is
    /// there, and for the simulated one, which sees the patient's own manikin.
    std::shared_ptr<Tracker> m_device;
    std::atomic<std::shared_ptr<const Published>> m_published;
    bool m_sharesLaryngoscope = false;
    QTimer m_looking; ///< polls the guard, and reports the standing
    StandingReport m_report;
    std::unique_ptr<ManikinBreaths> m_manikin; ///< last, because it uses the members above
};

} // namespace carina
