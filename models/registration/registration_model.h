#pragma once

#include "models/patient/patient_model.h"
#include "models/registration/fit_task.h"
#include "models/registration/landmark_task.h"
#include "models/registration/stylus_task.h"
#include "models/registration/stylus_watch.h"
#include "models/registration/surface_finder.h"
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

/// A landmark as a technician follows it.
struct LandmarkRow {
    QString name;
    Vec3 p_AQ = Vec3::Zero();
    std::optional<double> spread_mm{};   ///< of the stylus while it was touched; none before
    std::optional<double> residual_mm{}; ///< after the fit
    std::optional<double> leftOut_mm{};  ///< from the fit of all others
    bool isStale = false;                ///< touched, but something beneath has changed since
    bool isNext = false;                 ///< the one to touch, or to pick on the model
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
/// any order; a task that waits for another says so. Everything a person achieves is in the site
/// file before it is shown as done; a new model on the same file goes on where the last one stood.
class RegistrationModel : public QObject
{
    Q_OBJECT

public:
    /// The site as the file has it, or a new one where there is no file.
    /// @returns what readSiteFile refuses, other than FileNotFound; OtherPatient where the file
    ///          holds landmarks of another one.
    [[nodiscard]] static Result<Site> siteOf(const std::filesystem::path& file,
                                             const PatientModel& patient);

    /// What a registration is made with.
    struct Workplace {
        std::filesystem::path file;               ///< of the site
        const Tracker* tracker = nullptr;         ///< started and stopped by its owner
        QString trackerName;                      ///< as shown
        ReadSessionClock clock;                   ///< the clock of the tracker's samples
        std::vector<LandmarkCatalogue> landmarks; ///< sets of this patient, the recommended first
        std::vector<Landmark> checks{};           ///< places to check a registration at
        SiteEditor::Today today = &QDateTime::currentDateTimeUtc;
    };

    /// @param site as siteOf gave it
    /// @pre patient and tracker outlive this.
    RegistrationModel(Workplace workplace, Site site, const PatientModel& patient,
                      QObject* parent = nullptr);

    [[nodiscard]] const Site& site() const { return m_editor.site(); }
    [[nodiscard]] const PatientModel& patient() const { return m_patient; }
    [[nodiscard]] QString trackerName() const { return m_workplace.trackerName; }

    [[nodiscard]] const std::filesystem::path& siteFile() const { return m_workplace.file; }

    [[nodiscard]] SiteStep step() const { return site().step; }
    [[nodiscard]] SiteTask task(SiteStep step) const;
    /// The first page whose task is not done; Overview where all are.
    [[nodiscard]] SiteStep nextStep() const;
    [[nodiscard]] QStringList health() const;

    /// What to do now, in a sentence.
    [[nodiscard]] QString instruction() const;
    /// What went wrong last, in a sentence; empty since something went right.
    [[nodiscard]] QString problem() const { return m_editor.problem(); }
    /// What was written where, in a sentence; empty since something else happened.
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

    /// The tools that the tracker reports, and how it sees them now.
    [[nodiscard]] std::vector<ToolStatus> tools() const;

    [[nodiscard]] std::vector<LandmarkRow> landmarks() const;
    /// What is marked on the model: the landmarks, or the places to check while these are.
    [[nodiscard]] std::vector<LandmarkRow> places() const;
    /// Index of the landmark that is touched or picked next; nothing where none is.
    [[nodiscard]] std::optional<std::size_t> nextLandmark() const;
    /// How much of the present task's hold or swing is done, 0 to 1.
    [[nodiscard]] double progress() const;

    /// The tip on the anatomy, once it is registered and while the stylus is seen.
    [[nodiscard]] std::optional<StylusOnAnatomy> stylusOnAnatomy() const;

    [[nodiscard]] bool canUndo() const;

public Q_SLOTS:
    /// Takes in what the tracker saw since the last look; happens by itself 30 times a second.
    void look();
    void enter(carina::SiteStep step);
    void setOperator(const QString& name);
    void useTracker();
    /// A click on the model: moves a landmark, or names a place to check.
    void pick(const carina::Vec3& p_A_eye, const carina::Vec3& dir_A);
    /// Takes the point that the tip is at, for a key or a foot switch.
    void takeNow();
    void undo();
    /// Puts this site's file beside another name, whole.
    void exportSite(const QString& file);
    /// Takes over what another file has of this patient; can be undone.
    void importSite(const QString& file);

Q_SIGNALS:
    /// The site, the step or a problem changed.
    void changed();
    /// Something was achieved by hand, away from the screen: to be heard.
    void told(const QString& words);

private:
    void followStep();
    void forgetChoices();
    /// What the stylus is watched for on this page.
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
    std::optional<SiteStep> m_followed; ///< the page that the stylus is watched for
    std::optional<Vec3> m_followedTip;
    QTimer m_timer;
};

} // namespace carina
