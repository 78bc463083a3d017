#pragma once

#include "models/patient/patient_model.h"
#include "models/registration/stylus_watch.h"
#include "models/registration/surface_finder.h"
#include "models/site/site_editor.h"

#include <vector>

namespace carina
{

/// A point at which the registration is checked, and the result.
struct CheckPoint {
    QString name{};
    Vec3 p_AQ = Vec3::Zero();
    std::optional<double> error_mm{}; ///< once it was touched
    double bound_mm = 0.0;            ///< 95 % bound expected for error_mm
    /// The bound by which the verdict judges: all places that were touched stay within theirs
    /// together in 95 of 100 registrations. Not below bound_mm; 0 before error_mm is known.
    double limit_mm = 0.0;
    [[nodiscard]] bool isWithin() const { return error_mm && *error_mm <= bound_mm; }
    /// Beyond its own bound, which one in twenty is, and not beyond the limit.
    [[nodiscard]] bool isTolerated() const
    {
        return error_mm && !isWithin() && *error_mm <= limit_mm;
    }
};

/// Verifies a registration at points that were not used in its fit, and records the verdict.
class VerifyTask
{
public:
    /// The least number of touched points for a verdict; not all proposed points need be
    /// accessible.
    static constexpr std::size_t kFewestPoints = 2;
    /// A touch farther from a check point than this is refused.
    static constexpr Length kFarthestCheck = millimetres(40.0);

    /// @param places further check points; landmarks used in the fit are left out
    /// @pre the references outlive this.
    VerifyTask(SiteEditor& editor, StylusWatch& watch, const PatientModel& patient,
               const SurfaceFinder& surfaces, std::vector<Landmark> places);

    /// All check points with their bounds: the edge of the upper incisors, the given places that
    /// the fit did not use, and the picked ones.
    [[nodiscard]] std::vector<CheckPoint> points() const;
    /// The point that the next touch is for; std::nullopt if all were touched.
    [[nodiscard]] std::optional<std::size_t> next() const;
    void choose(std::optional<std::size_t> point);

    /// Adds the point where a ray first meets a surface, snapped to its nearest tip or ridge.
    void pick(const Vec3& p_A_eye, const Vec3& dir_A);
    /// Whether the point picked last is not touched yet; dropPicked() removes it.
    [[nodiscard]] bool hasPicked() const;
    void dropPicked();

    /// Records a touch; does nothing if next() is empty.
    void take(const StylusTouch& touch);

    /// Whether the registration has an error estimate. One from an older site file has none, and
    /// then points() is empty.
    [[nodiscard]] bool canJudge() const;
    /// Whether all points were touched.
    [[nodiscard]] bool isComplete() const;
    /// Whether a place was touched at the height of the airway: above the middle between carina and
    /// glottis, and not higher above the incisors than that is below the glottis.
    [[nodiscard]] bool hasAirwayPoint() const;
    /// The verdict from the points touched so far, jointly at 95 %; Open while there are fewer than
    /// kFewestPoints.
    [[nodiscard]] Verdict suggestion() const;
    /// How many places the verdict judges together.
    [[nodiscard]] std::size_t touched() const;
    /// Whether a verdict is recorded and no point was touched after it.
    [[nodiscard]] bool isRecorded() const;
    /// @pre at least kFewestPoints were touched.
    void record(Verdict verdict);

private:
    [[nodiscard]] bool isTouched(const CheckPoint& point) const;
    /// As points(), without the bounds, whose computation takes some milliseconds.
    [[nodiscard]] std::vector<CheckPoint> places() const;
    /// The bound in metres that this share of the errors stays below at a point, for a touch with
    /// the FLE of the fit.
    /// @pre canJudge()
    [[nodiscard]] double boundAt(const Vec3& p_AQ, double share) const;
    /// The share of errors below the limit of one place.
    [[nodiscard]] double shareOfOne() const;

    SiteEditor& m_editor;
    StylusWatch& m_watch;
    const PatientModel& m_patient;
    const SurfaceFinder& m_surfaces;
    std::vector<Landmark> m_places;   ///< given check points of this patient
    std::vector<CheckPoint> m_picked; ///< touched or not
    std::optional<std::size_t> m_chosen;
};

} // namespace carina
