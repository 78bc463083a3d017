#pragma once

#include "models/patient/patient_model.h"
#include "models/registration/stylus_watch.h"
#include "models/registration/surface_finder.h"
#include "models/site/site_editor.h"

#include <vector>

namespace carina
{

/// A place to check the registration at, and how it did.
struct CheckPoint {
    QString name{};
    Vec3 p_AQ = Vec3::Zero();
    std::optional<double> error_mm{}; ///< once it was touched
    double bound_mm = 0.0;            ///< that 95 % of such errors stay below
    [[nodiscard]] bool isWithin() const { return error_mm && *error_mm <= bound_mm; }
};

/// Checks a registration at places that were not used in its fit, and keeps the verdict.
class VerifyTask
{
public:
    /// Fewer tell nothing. A manikin that hides one of the places can be judged by the others.
    static constexpr std::size_t kFewestPoints = 2;
    /// What is farther from a place was not meant for it.
    static constexpr Length kFarthestCheck = millimetres(40.0);

    /// @param places to check at besides; those that the fit uses are left out
    /// @pre the references outlive this.
    VerifyTask(SiteEditor& editor, StylusWatch& watch, const PatientModel& patient,
               const SurfaceFinder& surfaces, std::vector<Landmark> places);

    /// All with their bounds. The upper incisors' edge, places that the fit did not use, and those
    /// that were picked.
    [[nodiscard]] std::vector<CheckPoint> points() const;
    /// The place that is checked by the next touch.
    [[nodiscard]] std::optional<std::size_t> next() const;
    void choose(std::optional<std::size_t> point);

    /// Adds the place that a ray first meets.
    void pick(const Vec3& p_A_eye, const Vec3& dir_A);
    /// Whether a place was added that is not touched yet; and takes the latest back.
    [[nodiscard]] bool hasPicked() const;
    void dropPicked();

    /// Does nothing where no place is left to check.
    void take(const StylusTouch& touch);

    /// Whether the fit tells how large an error may be: one of an older site file does not, and
    /// has no places to check.
    [[nodiscard]] bool canJudge() const;
    /// Whether each place that is proposed was touched.
    [[nodiscard]] bool isComplete() const;
    /// What the points touched so far say; Open while they are too few.
    [[nodiscard]] Verdict suggestion() const;
    /// Whether the verdict is recorded, and no place was touched since.
    [[nodiscard]] bool isRecorded() const;
    /// @pre at least kFewestPoints were touched.
    void record(Verdict verdict);

private:
    [[nodiscard]] bool isTouched(const CheckPoint& point) const;
    /// As points(), without their bounds, which take some milliseconds.
    [[nodiscard]] std::vector<CheckPoint> places() const;
    /// Of 95 % at a place, for a touch as uncertain as those of the fit. @pre canJudge()
    [[nodiscard]] double boundAt(const Vec3& p_AQ, double share) const;

    SiteEditor& m_editor;
    StylusWatch& m_watch;
    const PatientModel& m_patient;
    const SurfaceFinder& m_surfaces;
    std::vector<Landmark> m_places;   ///< of this patient, to be checked at
    std::vector<CheckPoint> m_picked; ///< touched or not
    std::optional<std::size_t> m_chosen;
};

} // namespace carina
