#pragma once

#include "engine/net/node/session_node.h"
#include "engine/session/station_tracking.h"
#include "models/patient/patient_source.h"
#include "models/site/site_setup.h"
#include "models/station/chin_probe_model.h"
#include "models/station/people_poses.h"
#include "models/station/standing_report.h"
#include "models/station/tool_status.h"
#include "models/tracker/made_tracker.h"
#include "models/tracker/played_hands.h"
#include "models/tracker/pose_recording.h"

#include <QTimer>

#include <atomic>
#include <string>
#include <vector>

namespace carina
{

/// The tools of a program's tracker in a session: measured by the tracker, brought into the frame
/// of the patient by the site, and shared with everybody at the station where this program's
/// participant is. Patient, tracker, its devices and the site can be replaced during the session.
/// Lives on the GUI thread.
class SharedTools
{
public:
    /// The site as of now, for a patient; std::nullopt: the simulated manikin is registered without
    /// error.
    using Place = std::optional<SitePlace>;
    using PlaceOf = std::function<Result<Place>(const PatientModel&)>;
    /// The true X_HA of a simulated head at a time.
    using TrueHead = std::function<std::optional<RigidTransform>(SessionTime)>;

    struct Hardware {
        /// One that is not simulated needs a Place.
        std::optional<TrackerChoice> tracker{};
        Frequency manikinBreathes{}; ///< the simulated manikin; 0: it lies still
        PoseTreatment treatment{};   ///< of the tracker's poses
    };

    /// What becomes of the devices where another tracker is given.
    enum class Devices : std::uint8_t {
        Anew,  ///< all are begun with anew
        RunOn, ///< those that both trackers have go on (MadeTracker::next)
    };

    /// @pre node outlives this.
    SharedTools(SessionNode& node, Hardware hardware, PlaceOf placeOf);
    ~SharedTools();
    SharedTools(const SharedTools&) = delete;
    SharedTools& operator=(const SharedTools&) = delete;

    /// The station at which the patient lies; tools are shared while this program's participant is
    /// there.
    void setStation(StationId station);
    /// Replaces the patient; a tracker that is not simulated goes on. While its site has no
    /// registration that can be used, nothing is tracked.
    /// @returns the error of its site or of the tracker; nothing is changed then.
    [[nodiscard]] Result<void> lay(const SharedPatientModel& patient);
    /// The same in any case: where lay() would fail, the tracker is taken away, and trackerSight()
    /// says why.
    void layAnyhow(const SharedPatientModel& patient);
    /// Applies the present site; of one that cannot be used only the standing, and of a file that
    /// cannot be read that there is none.
    void takePlace();
    /// Works with another tracker from now on, or with none; the patient is laid anew. Where the
    /// first device runs on, and the site has no registration any more that can be used, that of
    /// before is used on.
    /// @pre lay() succeeded.
    /// @returns the errors of lay(); NotRegistered for one that is not simulated where there is no
    ///          site. The tracker before is used on then.
    [[nodiscard]] Result<void> setTracker(std::optional<TrackerChoice> tracker,
                                          Devices devices = Devices::Anew);
    /// Lets go of the device of its tracker, or uses it again: its tools are lost meanwhile. No
    /// effect on a tracker without a device.
    void holdTracker(bool holds);
    /// The callback is called with another patient, tracker or tool in place, while those before
    /// still exist.
    void onReplaced(std::function<void()> callback) { m_onReplaced.push_back(std::move(callback)); }

    // @pre lay() succeeded. Results are valid until the next replacement.
    /// With the tube of the site, where that is calibrated.
    [[nodiscard]] const SharedPatientModel& patient() const { return m_laid->patient; }
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
    /// Empty without a simulation.
    [[nodiscard]] const TrueHead& truth() const { return m_laid->truth; }

    /// How far the registration can be relied on; std::nullopt without a tracker.
    [[nodiscard]] std::optional<RegistrationStanding> standing() const;
    /// How the tracker sees its tools now; std::nullopt without a tracker, unless it was taken away
    /// by layAnyhow().
    [[nodiscard]] std::optional<TrackerSight> trackerSight() const;
    /// Has the tracker's poses predicted or not, and smoothed, also those of the next patient.
    void treat(const PoseTreatment& treatment);
    [[nodiscard]] const PoseTreatment& treatment() const { return m_hardware.treatment; }
    /// The one that it works with now; nothing without one.
    [[nodiscard]] const std::optional<TrackerChoice>& tracker() const { return m_hardware.tracker; }
    /// Why layAnyhow() took the tracker away, until another one is given or taken.
    [[nodiscard]] const std::optional<Error>& fault() const { return m_fault; }

    /// The own objects as they are to be drawn, of whatever is tracked with then: the stylus as
    /// what it points at, and hands for a person who looks at a screen; who wears a headset sees
    /// their own (StationScene). Valid while this exists.
    [[nodiscard]] ObjectPoses posesOnScreen() const;
    /// What is shared of a tool: its newest pose X_AO; of the stylus that of its tip. May be called
    /// from any thread, also when this exists no more, while the node does.
    [[nodiscard]] PoseSource source(ToolRole tool) const;
    /// Has a recording go on with the present tools.
    void recordBy(PoseRecording& recording) const;

private:
    struct Laid {
        SharedPatientModel given;   ///< as the session has it
        SharedPatientModel patient; ///< with the tube of the site
        /// Shared with the node's thread, which reads poses; null without a tracker, and while the
        /// site has no registration that can be used.
        std::shared_ptr<StationTracking> tracking{};
        TrueHead truth{};
        /// What the simulated hands play; shared with the tracker's thread.
        std::shared_ptr<PlayedHands> played{};
        RigidTransform X_SP_played{};               ///< of the stylus that they hold
        std::unique_ptr<RegistrationGuard> guard{}; ///< of the tracking; null without a site
        Place place{};                              ///< as read from the site last
    };

    /// What the node's thread reads poses from.
    struct Published {
        std::shared_ptr<StationTracking> tracking;
        /// The stylus's tip P, with -z ahead along the shaft, in the frame of its markers; nothing
        /// where it is not calibrated.
        std::optional<RigidTransform> X_SP;
        StationId station; ///< of the patient
        /// The name under which it is shared.
        std::string laryngoscope;

        [[nodiscard]] std::optional<PoseSample> newest(ToolRole tool) const;
    };
    using Board = std::atomic<std::shared_ptr<const Published>>;

    [[nodiscard]] Result<void> replace(const SharedPatientModel& patient,
                                       std::optional<MadeTracker> made);
    [[nodiscard]] Result<void> track(Laid& laid, std::optional<MadeTracker>& made) const;
    void useRegistrationOn(Laid& laid, const std::optional<MadeTracker>& made) const;
    [[nodiscard]] Result<void> simulate(Laid& laid) const;
    [[nodiscard]] Result<void> connect(Laid& laid, std::optional<MadeTracker>& made) const;
    void stop(const Laid& before, const std::optional<MadeTracker>& made) const;
    [[nodiscard]] bool isTracking(const Tracker& tracker) const;
    [[nodiscard]] ReadSessionClock clock() const;
    [[nodiscard]] std::optional<PoseSample> shownAt(ToolRole tool, SessionTime t) const;
    /// X_SP as Published has it.
    [[nodiscard]] static std::optional<RigidTransform> shaftOf(const Laid& laid);
    void publishPoses();
    void share();
    void share(ObjectKind kind, ToolRole tool, const char* name);
    void nameLaryngoscope();
    void shareLaryngoscope();

    SessionNode& m_node;
    StationId m_station; ///< where the patient lies
    Hardware m_hardware;
    PlaceOf m_placeOf;
    std::vector<std::function<void()>> m_onReplaced;
    std::unique_ptr<Laid> m_laid;
    /// Of m_hardware.tracker, shared with m_laid: it runs on for another patient. Nothing before it
    /// is there, and for the simulated one, which sees the patient's own manikin.
    std::optional<MadeTracker> m_made;
    std::optional<Error> m_fault; ///< for which the tracker was taken away
    /// Shared with the sources that the node has, which may outlive this.
    std::shared_ptr<Board> m_board = std::make_shared<Board>();
    bool m_shares = false;
    std::string m_laryngoscope;               ///< its name; empty while there was none
    std::vector<std::string> m_laryngoscopes; ///< the names under which it was shared
    StandingReport m_report;
    QTimer m_looking; ///< polls the guard, and reports the standing
};

} // namespace carina
