#include "models/fit_task.h"

#include "engine/registration/error_quadric.h"
#include "engine/registration/localisation_error.h"
#include "engine/registration/registration_error.h"
#include "models/site_changes.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

constexpr Length kOrderFle = millimetres(2.0); ///< of a hand that is not careful
constexpr double kFalseAlarm = 0.01;           ///< share of good fits of which a landmark is named

class FitWords
{
    Q_DECLARE_TR_FUNCTIONS(FitTask)

public:
    static QString ofOrder(TouchOrder order)
    {
        switch (order) {
        case TouchOrder::AsGiven:
            return {};
        case TouchOrder::Exchanged:
            return tr("Landmarks were exchanged: the touches fit in another order.");
        case TouchOrder::MirrorImage:
            return tr("The touches are the mirror image of the landmarks: the patient's left and "
                      "right, or an axis of an imported file, are exchanged.");
        case TouchOrder::Unexplained:
            return tr("No order of the landmarks explains the touches: one was touched at a wrong "
                      "place, or the patient is not this manikin's.");
        }
        return {};
    }

    static QString standsOut(const std::string& landmark, double distance)
    {
        return tr("%1 lies %2 mm from where the other landmarks put it: touch it again.")
            .arg(QString::fromStdString(landmark))
            .arg(inMillimetres(metres(distance)), 0, 'f', 1);
    }
};

/// A touch, and how far it lies from where the fit of all others puts it.
struct LeftOut {
    Vec3 p_AQ = Vec3::Zero(); ///< of its landmark
    double distance = 0.0;    ///< metres
    Mat3 covariance_A = Mat3::Zero();
    double degrees = 0.0;

    [[nodiscard]] double ratio() const { return distance / std::sqrt(covariance_A.trace()); }
    [[nodiscard]] bool isTooFar(std::size_t landmarks) const
    {
        return distance
               > errorBound(covariance_A, degrees, 1.0 - kFalseAlarm / double(landmarks)).si;
    }
};

/// How uncertain that is by the residuals of the others: of the touch itself, and of their fit.
std::optional<LeftOut> leftOut(std::vector<LandmarkPair> pairs, std::size_t landmark)
{
    const LandmarkPair out = pairs[landmark];
    pairs.erase(pairs.begin() + std::ptrdiff_t(landmark));
    const auto others = fitRigid(pairs);
    if (!others)
        return std::nullopt;
    LocalisationError fle = localisationError(metres(others->rms), pairs.size());
    fle.rms = std::max(fle.rms, kLeastFle);
    std::vector<Vec3> p_A;
    for (const LandmarkPair& pair : pairs)
        p_A.push_back(pair.p_AQ);
    const auto covariance = fitCovariance(equalErrors(p_A, fle.rms));
    if (!covariance)
        return std::nullopt;
    return LeftOut{.p_AQ = out.p_AQ,
                   .distance = (out.p_AQ - others->X_AM * out.p_MQ).norm(),
                   .covariance_A = pointCovariance(*covariance, out.p_AQ)
                                   + fle.rms.si * fle.rms.si / 3.0 * Mat3::Identity(),
                   .degrees = fle.degrees};
}

/// The touch that all others contradict, if there is one.
std::optional<LeftOut> standsOut(const std::vector<LandmarkPair>& pairs)
{
    std::optional<LeftOut> worst;
    for (std::size_t i = 0; i < pairs.size(); ++i)
        if (const auto each = leftOut(pairs, i); each && (!worst || each->ratio() > worst->ratio()))
            worst = each;
    return worst && worst->isTooFar(pairs.size()) ? worst : std::nullopt;
}

/// Surfaces under thin skin, which a stylus can be pressed on.
bool canBeSwabbed(const PatientSurface& surface)
{
    return surface.description.role == PartRole::Rib
           || surface.description.role == PartRole::Mandible;
}

} // namespace

FitTask::FitTask(SiteEditor& editor, StylusWatch& watch, const PatientModel& patient,
                 const SurfaceFinder& surfaces)
    : m_editor{editor},
      m_watch{watch},
      m_patient{patient},
      m_surfaces{surfaces},
      m_targets{registrationTargets(patient)}
{
}

void FitTask::fit()
{
    auto next = withFit(m_editor.site(), {.tool = m_watch.tool(),
                                          .X_TJ = m_watch.probe(ToolRole::Jaw),
                                          .X_TB = m_watch.probe(ToolRole::Manikin),
                                          .at = m_editor.now()});
    if (!next)
        return m_editor.refuse(next.error());
    m_editor.become(std::move(*next));
}

std::optional<OrderFinding> FitTask::orderFound() const
{
    const auto found = recogniseOrder(touchedPairs(m_editor.site()), kOrderFle);
    return found ? std::optional{*found} : std::nullopt;
}

TouchOrder FitTask::order() const
{
    const auto found = orderFound();
    return found ? found->order : TouchOrder::AsGiven;
}

void FitTask::repairOrder()
{
    const auto found = orderFound();
    if (!found || found->order != TouchOrder::Exchanged)
        return;
    auto next = withFit(withOrder(m_editor.site(), found->touchOf),
                        {.tool = m_watch.tool(),
                         .X_TJ = m_watch.probe(ToolRole::Jaw),
                         .X_TB = m_watch.probe(ToolRole::Manikin),
                         .at = m_editor.now()});
    if (!next)
        return m_editor.refuse(next.error());
    m_editor.become(std::move(*next));
}

QStringList FitTask::findings() const
{
    QStringList sentences;
    if (const auto found = orderFound(); found && found->order != TouchOrder::AsGiven)
        sentences << FitWords::ofOrder(found->order);
    const auto& registration = m_editor.site().registration;
    if (!registration || registration->stale)
        return sentences;
    if (const auto worst = standsOut(touchedPairs(m_editor.site())))
        sentences << FitWords::standsOut(
            std::ranges::find(m_editor.site().catalogue->landmarks, worst->p_AQ, &Landmark::p_AQ)
                ->name,
            worst->distance);
    return sentences;
}

std::vector<ExpectedError> FitTask::expected() const
{
    const auto& registration = m_editor.site().registration;
    if (!registration || registration->degrees == 0.0)
        return {};
    return expectedErrors(registration->covariance_A, registration->degrees, m_targets);
}

std::optional<FitTask::Localisation> FitTask::localisation() const
{
    const auto& registration = m_editor.site().registration;
    if (!registration || registration->degrees == 0.0)
        return std::nullopt;
    const LocalisationError fle{metres(registration->fle), registration->degrees};
    return Localisation{fle.rms, fle.limit()};
}

std::optional<Mat4> FitTask::errorQuadric() const
{
    const auto& registration = m_editor.site().registration;
    if (!registration || registration->degrees == 0.0)
        return std::nullopt;
    return carina::errorQuadric(registration->covariance_A);
}

QStringList FitTask::swabSurfaces() const
{
    QStringList names;
    for (const PatientSurface& surface : m_patient.surfaces())
        if (canBeSwabbed(surface))
            names << QString::fromStdString(surface.name);
    return names;
}

void FitTask::startSwab()
{
    const StylusTip* tip = m_editor.site().stylus(m_watch.tool());
    if (!tip || !m_editor.site().registration)
        return;
    m_watch.watchFor(StylusUse::Swab, tip->p_SQ);
    Q_EMIT m_editor.changed();
}

void FitTask::cancelSwab()
{
    m_watch.watchFor(StylusUse::Nothing, std::nullopt);
    Q_EMIT m_editor.changed();
}

void FitTask::refine(const QString& surface)
{
    const SurfaceTree* tree = m_surfaces.surface(surface.toStdString());
    const auto& registration = m_editor.site().registration;
    if (!tree || !registration)
        return;
    const RigidTransform X_MT = registration->X_AM.inverse() * registration->X_AT;
    std::vector<Vec3> p_MQ;
    for (const Vec3& p_TQ : m_watch.swab())
        p_MQ.push_back(X_MT * p_TQ);
    m_watch.watchFor(StylusUse::Nothing, std::nullopt);
    const auto refinement = refineOnSurface(*tree, p_MQ, registration->X_AM);
    if (!refinement)
        return m_editor.refuse(refinement.error());
    m_editor.become(withSwab(m_editor.site(), surface.toStdString(), p_MQ.size(), *refinement));
}

} // namespace carina
