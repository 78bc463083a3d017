#include "models/registration/fit_task.h"

#include "engine/registration/error/error_quadric.h"
#include "engine/registration/error/leave_one_out.h"
#include "engine/registration/error/localisation_error.h"
#include "engine/registration/error/registration_error.h"
#include "models/site/site_changes.h"
#include "models/site/site_fit.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <utility>

namespace carina
{
namespace
{

constexpr Length kOrderFle = millimetres(2.0); ///< of a hand that is not careful

class FitWords
{
    Q_DECLARE_TR_FUNCTIONS(FitTask)

public:
    static QString ofOrder(TouchOrder order, const QStringList& exchanged)
    {
        switch (order) {
        case TouchOrder::AsGiven:
            return {};
        case TouchOrder::Exchanged:
            return tr("Landmarks were exchanged: the touches fit in another order. These are "
                      "others' touches: %1.")
                .arg(exchanged.join(tr(", ")));
        case TouchOrder::MirrorImage:
            return tr("The touches are the mirror image of the landmarks: the patient's left and "
                      "right, or an axis of an imported file, are exchanged.");
        case TouchOrder::Unexplained:
            return tr("No order of the landmarks explains the touches: one was touched at a wrong "
                      "place, or the patient is not this manikin's.");
        }
        return {};
    }

    /// @param p_A_glottis as the patient has it
    static QString ofScale(const ManikinScale& found, const std::vector<LandmarkPair>& pairs,
                           const Vec3& p_A_glottis)
    {
        Vec3 p_A_mean = Vec3::Zero();
        for (const LandmarkPair& pair : pairs)
            p_A_mean += pair.p_AQ / double(pairs.size());
        const double off = std::abs(found.scale - 1.0);
        const QString sentence =
            found.scale > 1.0 ? tr("The manikin is about %1\u00a0% larger than the patient: the "
                                   "glottis is drawn about %2\u00a0mm from its place, whatever the "
                                   "expected errors say. Choose a taller patient, or move the "
                                   "landmarks to where the patient has the places you touch.")
                              : tr("The manikin is about %1\u00a0% smaller than the patient: the "
                                   "glottis is drawn about %2\u00a0mm from its place, whatever the "
                                   "expected errors say. Choose a shorter patient, or move the "
                                   "landmarks to where the patient has the places you touch.");
        return sentence.arg(100.0 * off, 0, 'f', 0)
            .arg(inMillimetres(off * metres((p_A_glottis - p_A_mean).norm())), 0, 'f', 0);
    }

    static QString ofLocalisation(const FitTask::Localisation& fle)
    {
        QString sentence = tr("Error of a touch: %1\u00a0mm (RMS), with 95\u00a0% confidence below "
                              "%2\u00a0mm;")
                               .arg(inMillimetres(fle.rms), 0, 'f', 1)
                               .arg(inMillimetres(fle.limit), 0, 'f', 1)
                           + QLatin1Char(' ');
        sentence += fle.pooled == 0 ? tr("from these touches.")
                                    : tr("from these touches and %n earlier registration(s).",
                                         nullptr, fle.pooled);
        if (fle.disagreeing > 0)
            sentence += QLatin1Char(' ')
                        + tr("%n earlier registration(s) strayed by more or less than chance "
                             "explains and are not used.",
                             nullptr, fle.disagreeing);
        return sentence;
    }

    static QString standsOut(const QString& landmark, Length distance)
    {
        return tr("%1 lies %2\u00a0mm from where the other landmarks put it: touch it again.")
            .arg(landmark)
            .arg(inMillimetres(distance), 0, 'f', 1);
    }
};

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
    Site site = m_editor.site();
    if (site.relay)
        return m_editor.refuse(
            FitWords::tr("The manikin is being registered again: touch its landmarks, "
                         "or leave it where it was."));
    if (isLaidAnew(site))
        return m_editor.refuse(
            FitWords::tr("The manikin was registered again since its landmarks were "
                         "touched: touch them again for a new fit."));
    // A fit that leaves exchanged landmarks so is of no use to anyone.
    if (const auto found = orderFound(); found && found->order == TouchOrder::Exchanged)
        site = withOrder(std::move(site), found->touchOf);
    auto next = withFit(std::move(site), fitInputs(m_watch, m_editor.now()));
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

std::optional<ManikinScale> FitTask::scaleFound() const
{
    const auto pairs = touchedPairs(m_editor.site());
    const auto scale = manikinScale(pairs);
    // A single wrong touch is mended first: it may look like another size.
    if (!scale || !scale->isOff() || outlyingLandmark(withAnatomyScaled(pairs, scale->scale)))
        return std::nullopt;
    return *scale;
}

QString FitTask::nameOf(const Vec3& p_AQ) const
{
    const auto& landmarks = m_editor.site().catalogue->landmarks;
    return QString::fromStdString(std::ranges::find(landmarks, p_AQ, &Landmark::p_AQ)->name);
}

QStringList FitTask::findings() const
{
    const auto pairs = touchedPairs(m_editor.site());
    const auto found = orderFound();
    const bool isReordered =
        found && (found->order == TouchOrder::Exchanged || found->order == TouchOrder::MirrorImage);
    const auto scale = isReordered ? std::nullopt : scaleFound();
    QStringList sentences;
    if (scale)
        sentences << FitWords::ofScale(*scale, pairs, m_patient.landmarks().p_A_glottis);
    else if (found && found->order != TouchOrder::AsGiven)
        sentences << FitWords::ofOrder(found->order, exchangedIn(*found));
    const auto& registration = m_editor.site().registration;
    if (!registration || registration->stale)
        return sentences;
    sentences << findingsOfProbes();
    if (const auto outlier = outlyingLandmark(pairs); outlier && !isReordered && !scale)
        sentences << FitWords::standsOut(nameOf(pairs[outlier->landmark].p_AQ), outlier->distance);
    return sentences;
}

/// The landmarks whose touches belong to others.
QStringList FitTask::exchangedIn(const OrderFinding& found) const
{
    const auto pairs = touchedPairs(m_editor.site());
    QStringList exchanged;
    for (std::size_t i = 0; i < found.touchOf.size(); ++i)
        if (found.touchOf[i] != i)
            exchanged << nameOf(pairs[i].p_AQ);
    return exchanged;
}

/// @pre it is registered.
QStringList FitTask::findingsOfProbes() const
{
    const SiteRegistration& registration = *m_editor.site().registration;
    QStringList sentences;
    if (m_watch.has(ToolRole::Jaw) && !registration.X_JM)
        sentences << FitWords::tr("The chin probe was not seen: the patient's mouth will not open "
                                  "with the manikin's. Turn it to the tracker and fit again.");
    if (m_watch.has(ToolRole::Manikin) && !registration.X_BM)
        sentences << FitWords::tr("The body probe was not seen: the patient will not move with the "
                                  "manikin. Turn it to the tracker and fit again.");
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
    return Localisation{fle.rms, fle.limit(), registration->pooled, registration->disagreeing};
}

QString FitTask::localisationText() const
{
    const auto found = localisation();
    return found ? FitWords::ofLocalisation(*found) : QString{};
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
    if (!m_editor.site().stylus(m_watch.tool()) || !m_editor.site().registration)
        return;
    m_watch.watchFor(StylusUse::Swab);
    Q_EMIT m_editor.changed();
}

void FitTask::cancelSwab()
{
    m_watch.watchFor(StylusUse::Nothing);
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
    m_watch.watchFor(StylusUse::Nothing);
    const auto refinement = refineOnSurface(*tree, p_MQ, registration->X_AM);
    if (!refinement)
        return m_editor.refuse(refinement.error());
    m_editor.become(
        withSwab(m_editor.site(), m_watch.tool(), surface.toStdString(), p_MQ.size(), *refinement));
}

} // namespace carina
