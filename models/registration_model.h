#pragma once

#include "engine/io/site_file.h"
#include "models/patient_model.h"
#include "models/stylus_watch.h"
#include "models/surface_finder.h"
#include "models/tool_status.h"

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

/// Registers a patient's anatomy to a manikin, step by step: the logic of the wizard. Everything a
/// person achieves is in the site file before it is shown as done; a new model on the same file
/// goes on where the last one stood.
///
/// A change takes away what rests on it: a new stylus tip the touched points and the fit, another
/// place of a landmark its touch and the fit. Each change can be undone as a whole.
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
        std::filesystem::path file;  ///< of the site
        const Tracker* tracker;      ///< started and stopped by its owner
        QString trackerName;         ///< as shown
        ReadSessionClock clock;      ///< the clock of the tracker's samples
        LandmarkCatalogue landmarks; ///< those offered for this patient
    };

    /// @param site as siteOf gave it
    /// @pre patient and tracker outlive this.
    RegistrationModel(Workplace workplace, Site site, const PatientModel& patient,
                      QObject* parent = nullptr);

    [[nodiscard]] const Site& site() const { return m_site; }
    [[nodiscard]] const PatientModel& patient() const { return m_patient; }
    [[nodiscard]] QString trackerName() const { return m_workplace.trackerName; }

    [[nodiscard]] SiteStep step() const { return m_site.step; }
    [[nodiscard]] bool isDone(SiteStep step) const;
    /// Whether what the step needs is there.
    [[nodiscard]] bool canEnter(SiteStep step) const;
    /// Why not, in a sentence; empty where it can.
    [[nodiscard]] QString whyNot(SiteStep step) const;

    /// What to do now, in a sentence.
    [[nodiscard]] QString instruction() const;
    /// What went wrong last, in a sentence; empty since something went right.
    [[nodiscard]] QString problem() const { return m_problem; }

    /// The tools that the tracker reports, and how it sees them now.
    [[nodiscard]] std::vector<ToolStatus> tools() const;

    [[nodiscard]] std::vector<LandmarkRow> landmarks() const;
    /// Index of the landmark that is touched or picked next; nothing once all are touched.
    [[nodiscard]] std::optional<std::size_t> nextLandmark() const;
    /// How much of the present task's hold or swing is done, 0 to 1.
    [[nodiscard]] double progress() const;
    [[nodiscard]] bool isSwinging() const { return m_stylus.isSwinging(); }

    /// The tip on the anatomy, once it is registered and while the stylus is seen.
    [[nodiscard]] const std::optional<StylusOnAnatomy>& stylusOnAnatomy() const
    {
        return m_stylusOnAnatomy;
    }

    [[nodiscard]] bool canUndo() const { return !m_past.empty(); }

public Q_SLOTS:
    /// Takes in what the tracker saw since the last look; happens by itself 30 times a second.
    void look();
    void enter(carina::SiteStep step);
    void useTracker();
    /// Begins to collect poses of the stylus, its tip in a divot; ends by itself.
    void startSwing();
    void cancelSwing();
    /// Takes the landmarks as landmarks() lists them, and goes on to touching.
    void acceptLandmarks();
    /// Puts all landmarks back to their built-in places.
    void useBuiltinLandmarks();
    /// Chooses the landmark to touch again, or to pick on the model.
    void choose(std::size_t landmark);
    /// Takes the point where a ray first meets the patient as the chosen landmark's place.
    void pick(const carina::Vec3& p_A_eye, const carina::Vec3& dir_A);
    void fit();
    void undo();

Q_SIGNALS:
    /// The site, the step or a problem changed.
    void changed();
    /// A landmark was touched: for a sound.
    void touched();

private:
    void takeSwing(const std::vector<RigidTransform>& X_TS);
    void takeTouch(const DwellPoint& point);
    [[nodiscard]] std::optional<StylusOnAnatomy> foundStylus() const;
    /// Saves a change, which can then be undone, and shows it.
    bool become(Site next);
    /// Shown is only what is in the file.
    bool save(Site next);
    void refuse(const Error& error);
    [[nodiscard]] const LandmarkCatalogue& catalogue() const;

    Workplace m_workplace;
    Site m_site;
    const PatientModel& m_patient;
    StylusWatch m_stylus;
    SurfaceFinder m_surfaces;
    std::vector<Site> m_past; ///< what undo goes back to
    QString m_problem;
    std::optional<std::size_t> m_chosen;
    std::optional<StylusOnAnatomy> m_stylusOnAnatomy;
    QTimer m_timer;
};

} // namespace carina
