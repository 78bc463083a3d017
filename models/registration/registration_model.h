#pragma once

#include "models/patient/patient_model.h"
#include "models/registration/device_task.h"
#include "models/registration/fit_task.h"
#include "models/registration/landmark_task.h"
#include "models/registration/manikin_task.h"
#include "models/registration/stylus_task.h"
#include "models/registration/stylus_watch.h"
#include "models/registration/surface_finder.h"
#include "models/registration/tool_task.h"
#include "models/registration/touch_task.h"
#include "models/registration/verify_task.h"
#include "models/site/site_editor.h"
#include "models/site/site_tasks.h"
#include "models/station/tool_status.h"

#include <QObject>
#include <QString>
#include <QTimer>

#include <filesystem>
#include <optional>
#include <vector>

namespace carina
{

/// A landmark and the state of its registration.
struct LandmarkRow {
    QString name;
    Vec3 p_AQ = Vec3::Zero();
    std::optional<double> spread_mm{};   ///< of the stylus tip during the touch; empty before
    std::optional<double> residual_mm{}; ///< after the fit
    std::optional<double> leftOut_mm{};  ///< distance from the fit of all others
    bool isStale = false; ///< touched, but something that it depends on was changed since
    bool isNext = false;  ///< the one to touch, or to pick on the model
};

/// Where the stylus is on the registered anatomy.
struct StylusOnAnatomy {
    RigidTransform X_AS;
    Vec3 p_AQ = Vec3::Zero(); ///< of the tip
    QString nearestSurface{};
    double surface_mm = 0.0; ///< from the tip to it
    QString nearestLandmark{};
    double landmark_mm = 0.0;
};

/// Registers a patient's anatomy to a manikin: the logic of the wizard. Its pages can be entered in
/// any order; a task that depends on an unfinished one has the state Waits. A result is written to
/// the site file before it is shown as done; a new model on the same file continues from there.
class RegistrationModel : public QObject
{
    Q_OBJECT

public:
    /// The site in a file, or a new one if there is no such file.
    /// @returns the errors of readSiteFile, except FileNotFound; OtherPatient if the file has the
    ///          landmarks of another patient.
    [[nodiscard]] static Result<Site> siteOf(const std::filesystem::path& file,
                                             const PatientModel& patient);

    /// The tracker, file and landmarks of a registration.
    struct Workplace {
        std::filesystem::path file;                  ///< of the site
        const Tracker* tracker = nullptr;            ///< started and stopped by its owner
        QString trackerName;                         ///< as shown
        ReadSessionClock clock;                      ///< the clock of the tracker's samples
        std::vector<LandmarkCatalogue> landmarks;    ///< of this patient, recommended set first
        std::vector<Landmark> checks{};              ///< places to check a registration at
        KnownVolume usualVolume = KnownVolume::None; ///< of such a tracker
        SiteEditor::Today today = &QDateTime::currentDateTimeUtc;
        /// See DeviceTask::Access.
        std::optional<std::vector<SiteDevice>> trackedDevices{};
        MakeDevice makeDevice{};
        std::function<Result<void>(bool tracks)> track{};
        std::vector<Site> past{}; ///< of a model before, for undo()
    };

    /// @param site returned by siteOf
    /// @pre patient and tracker outlive this.
    RegistrationModel(Workplace workplace, Site site, const PatientModel& patient,
                      QObject* parent = nullptr);

    [[nodiscard]] const Site& site() const { return m_editor.site(); }
    [[nodiscard]] const PatientModel& patient() const { return m_patient; }
    [[nodiscard]] QString trackerName() const { return m_workplace.trackerName; }

    [[nodiscard]] const std::filesystem::path& siteFile() const { return m_workplace.file; }

    [[nodiscard]] SiteStep step() const { return site().step; }
    [[nodiscard]] SiteTask task(SiteStep step) const;
    /// The first page whose task is not done; Overview if all are.
    [[nodiscard]] SiteStep nextStep() const;
    [[nodiscard]] QStringList health() const;

    /// One sentence: what to do now.
    [[nodiscard]] QString instruction() const;
    /// One sentence: the last failure; empty after a success.
    [[nodiscard]] QString problem() const { return m_editor.problem(); }
    /// One sentence: which file was written; empty after any other event.
    [[nodiscard]] QString notice() const { return m_editor.notice(); }

    [[nodiscard]] StylusTask& stylus() { return m_stylusTask; }
    [[nodiscard]] const StylusTask& stylus() const { return m_stylusTask; }
    [[nodiscard]] LandmarkTask& landmarkTask() { return m_landmarkTask; }
    [[nodiscard]] const LandmarkTask& landmarkTask() const { return m_landmarkTask; }
    [[nodiscard]] TouchTask& touching() { return m_touchTask; }
    [[nodiscard]] const TouchTask& touching() const { return m_touchTask; }
    [[nodiscard]] FitTask& fitting() { return m_fitTask; }
    [[nodiscard]] const FitTask& fitting() const { return m_fitTask; }
    [[nodiscard]] VerifyTask& verifying() { return m_verifyTask; }
    [[nodiscard]] const VerifyTask& verifying() const { return m_verifyTask; }

    [[nodiscard]] ToolTask& toolTask() { return m_toolTask; }
    [[nodiscard]] const ToolTask& toolTask() const { return m_toolTask; }

    [[nodiscard]] DeviceTask& devices() { return m_deviceTask; }
    [[nodiscard]] const DeviceTask& devices() const { return m_deviceTask; }

    [[nodiscard]] ManikinTask& manikin() { return m_manikinTask; }
    [[nodiscard]] const ManikinTask& manikin() const { return m_manikinTask; }

    [[nodiscard]] KnownVolume usualVolume() const { return m_workplace.usualVolume; }
    /// What keeps the tracker from tracking, as a translated sentence; empty where nothing does.
    [[nodiscard]] QString trackerTrouble() const;
    /// Whether the tracker has such a tool, seen or not.
    [[nodiscard]] bool has(ToolRole role) const { return m_watch.has(role); }
    /// The tools that the tracker reports, and how it sees them now.
    [[nodiscard]] std::vector<ToolStatus> tools() const;

    [[nodiscard]] std::vector<LandmarkRow> landmarks() const;
    /// The points marked on the model: the landmarks; on the Verify page the check points; on the
    /// Overview, while the airway is touched, its places.
    [[nodiscard]] std::vector<LandmarkRow> places() const;
    /// Index of the landmark to touch or pick next; std::nullopt if there is none.
    [[nodiscard]] std::optional<std::size_t> nextLandmark() const;
    /// Progress of the present dwell, pivot or spin, 0 to 1.
    [[nodiscard]] double progress() const;

    /// Where the stylus is on the anatomy; std::nullopt before the fit and while the stylus is not
    /// seen.
    [[nodiscard]] std::optional<StylusOnAnatomy> stylusOnAnatomy() const;

    [[nodiscard]] bool canUndo() const;
    /// What the site was before, for a model that goes on with another tracker.
    [[nodiscard]] const std::vector<Site>& past() const { return m_editor.past(); }

public Q_SLOTS:
    /// Processes the tracker's samples since the last call; a timer calls it 30 times a second.
    void look();
    void enter(carina::SiteStep step);
    void setOperator(const QString& name);
    void useTracker();
    /// A click on the model: moves a landmark, or adds a check point.
    void pick(const carina::Vec3& p_A_eye, const carina::Vec3& dir_A);
    /// Takes the point at the tip now, for a key or a foot switch.
    void takeNow();
    void undo();
    /// Writes a complete copy of the site to another file.
    void exportSite(const QString& file);
    /// Replaces this site by that of another file for this patient; can be undone.
    void importSite(const QString& file);

Q_SIGNALS:
    /// The site, the step or a problem changed.
    void changed();
    /// The tracker was made of the site's devices, and these are others now: it has to be made
    /// again (DeviceTask::isOutdated).
    void devicesChanged();
    /// Something was done with the stylus, away from the screen: to be spoken aloud.
    void told(const QString& words);

private:
    void followStep();
    void forgetChoices();
    [[nodiscard]] std::optional<ToolRole> touchedTool() const;
    [[nodiscard]] std::vector<LandmarkRow> airwayPlaces() const;
    /// What the stylus is used for on this page.
    [[nodiscard]] StylusUse use() const;
    /// Whether the page asks for one more point.
    [[nodiscard]] bool awaitsTouch() const;
    void take(const StylusTouch& touch);

    Workplace m_workplace;
    const PatientModel& m_patient;
    SiteEditor m_editor;
    StylusWatch m_watch;
    SurfaceFinder m_surfaces;
    StylusTask m_stylusTask;
    LandmarkTask m_landmarkTask;
    TouchTask m_touchTask;
    FitTask m_fitTask;
    VerifyTask m_verifyTask;
    ManikinTask m_manikinTask;
    ToolTask m_toolTask;
    DeviceTask m_deviceTask;
    std::optional<SiteStep> m_followed; ///< the page that the present stylus use belongs to
    std::optional<Vec3> m_followedTip;
    bool m_followedAirway = false;          ///< whether the airway is touched
    std::optional<ToolRole> m_followedTool; ///< which tool is touched
    QTimer m_timer;
};

} // namespace carina
