#pragma once

#include "engine/registration/fit/manikin_scale.h"
#include "engine/registration/fit/surface_refinement.h"
#include "engine/registration/landmarks/landmark_order.h"
#include "models/registration/landmark_task.h"
#include "models/registration/stylus_watch.h"

#include <QStringList>

namespace carina
{

/// Fits the anatomy to the touched landmarks, checks the touches for exchanged or wrong landmarks,
/// predicts the TRE at the targets (registrationTargets), and refines the fit with points swabbed
/// on a surface.
class FitTask
{
public:
    /// The least number of points of a swab.
    static constexpr std::size_t kFewestPoints = kFewestSwabPoints;

    /// @pre all outlive this.
    FitTask(SiteEditor& editor, StylusWatch& watch, const PatientModel& patient,
            const SurfaceFinder& surfaces);

    /// Fits X_AM to the fresh touches. Touches of exchanged landmarks are reassigned first. The
    /// site stays as it is, and SiteEditor::problem() says why, if the manikin was re-registered
    /// after the touches or if the fit fails.
    void fit();

    /// Whether the touches match the landmarks as given, in another order, or as a mirror image.
    [[nodiscard]] TouchOrder order() const;

    /// Warnings about the fit, one sentence each, the most important first.
    [[nodiscard]] QStringList findings() const;
    /// The expected TRE at each target, from the covariance of the registration; empty before the
    /// fit.
    [[nodiscard]] std::vector<ExpectedError> expected() const;

    /// The estimated FLE: RMS error of one touch, and the 95 % upper confidence limit of the true
    /// one.
    struct Localisation {
        Length rms;
        Length limit;
        int pooled = 0;      ///< earlier registrations by the same person that are in it
        int disagreeing = 0; ///< those that are not: their touches strayed by more or less
    };
    [[nodiscard]] std::optional<Localisation> localisation() const;
    /// That in words, and what it was estimated from; empty before the fit.
    [[nodiscard]] QString localisationText() const;

    /// Q such that [p 1] Q [p 1]^T is the mean squared TRE in m^2 at p in A, metres; std::nullopt
    /// before the fit.
    [[nodiscard]] std::optional<Mat4> errorQuadric() const;

    /// The surfaces that can be swabbed on a manikin: ribs and mandible, which lie under thin skin.
    [[nodiscard]] QStringList swabSurfaces() const;
    void startSwab();
    [[nodiscard]] bool isSwabbing() const { return m_watch.use() == StylusUse::Swab; }
    [[nodiscard]] std::size_t swabPoints() const { return m_watch.swab().size(); }
    void cancelSwab();
    /// Refines the registration with the swabbed points (refineOnSurface).
    /// @param surface one of swabSurfaces()
    void refine(const QString& surface);

private:
    [[nodiscard]] std::optional<OrderFinding> orderFound() const;
    /// The manikin's size where the touches show that it is not the patient's.
    [[nodiscard]] std::optional<ManikinScale> scaleFound() const;
    [[nodiscard]] QString nameOf(const Vec3& p_AQ) const;
    [[nodiscard]] QStringList exchangedIn(const OrderFinding& found) const;
    [[nodiscard]] QStringList findingsOfProbes() const;

    SiteEditor& m_editor;
    StylusWatch& m_watch;
    const PatientModel& m_patient;
    const SurfaceFinder& m_surfaces;
    std::vector<RegistrationTarget> m_targets;
};

} // namespace carina
