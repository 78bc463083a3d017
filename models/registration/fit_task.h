#pragma once

#include "engine/registration/fit/surface_refinement.h"
#include "engine/registration/landmarks/landmark_order.h"
#include "models/registration/landmark_task.h"
#include "models/registration/stylus_watch.h"

#include <QStringList>

namespace carina
{

/// Fits the anatomy to the touched landmarks, says what the touches tell about themselves, predicts
/// the error where it counts, and refines the fit on a surface that the stylus slides over.
class FitTask
{
public:
    /// Of a swab.
    static constexpr std::size_t kFewestPoints = kFewestSwabPoints;

    /// @pre all outlive this.
    FitTask(SiteEditor& editor, StylusWatch& watch, const PatientModel& patient,
            const SurfaceFinder& surfaces);

    /// Landmarks that were exchanged get each its own touch.
    void fit();

    /// Whether the touches belong to other landmarks than it was thought, or show a mirror image.
    [[nodiscard]] TouchOrder order() const;

    /// What a technician should know of the fit, each a sentence: the most pressing first.
    [[nodiscard]] QStringList findings() const;
    /// By the registration's own error; empty before there is one.
    [[nodiscard]] std::vector<ExpectedError> expected() const;

    /// What its residuals tell of the touches: root mean square error of one (FLE), and the limit
    /// that the true one is below with 95 %.
    struct Localisation {
        Length rms;
        Length limit;
    };
    [[nodiscard]] std::optional<Localisation> localisation() const;

    /// Its mean squared error at p in A: [p 1] Q [p 1]^T, m^2; nothing before there is one.
    [[nodiscard]] std::optional<Mat4> errorQuadric() const;

    /// Surfaces that a stylus can slide over on a manikin.
    [[nodiscard]] QStringList swabSurfaces() const;
    void startSwab();
    [[nodiscard]] bool isSwabbing() const { return m_watch.use() == StylusUse::Swab; }
    [[nodiscard]] std::size_t swabPoints() const { return m_watch.swab().size(); }
    void cancelSwab();
    /// Refines the registration by what was swabbed. @param surface one of swabSurfaces()
    void refine(const QString& surface);

private:
    [[nodiscard]] std::optional<OrderFinding> orderFound() const;

    SiteEditor& m_editor;
    StylusWatch& m_watch;
    const PatientModel& m_patient;
    const SurfaceFinder& m_surfaces;
    std::vector<RegistrationTarget> m_targets;
};

} // namespace carina
