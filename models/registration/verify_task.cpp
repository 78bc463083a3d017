#include "models/registration/verify_task.h"

#include "engine/core/expects.h"
#include "engine/registration/error/error_bound.h"
#include "models/site/site_changes.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

class VerifyWords
{
    Q_DECLARE_TR_FUNCTIONS(VerifyTask)
};

} // namespace

VerifyTask::VerifyTask(SiteEditor& editor, StylusWatch& watch, const PatientModel& patient,
                       const SurfaceFinder& surfaces, std::vector<Landmark> places)
    : m_editor{editor},
      m_watch{watch},
      m_patient{patient},
      m_surfaces{surfaces},
      m_places{std::move(places)}
{
}

std::vector<CheckPoint> VerifyTask::points() const
{
    std::vector<CheckPoint> points = places();
    for (CheckPoint& point : points) {
        point.bound_mm = inMillimetres(metres(boundAt(point.p_AQ, kBoundShare)));
        if (point.error_mm)
            point.limit_mm = inMillimetres(metres(boundAt(point.p_AQ, shareOfOne())));
    }
    return points;
}

/// Without their bounds, which take their time.
std::vector<CheckPoint> VerifyTask::places() const
{
    const Site& site = m_editor.site();
    if (!canJudge())
        return {};
    std::vector<CheckPoint> points{{.name = VerifyWords::tr("Edge of the upper incisors"),
                                    .p_AQ = m_patient.landmarks().p_A_incisors}};
    for (const Landmark& landmark : m_places)
        if (std::ranges::count(site.registration->residuals, landmark.name,
                               &LandmarkResidual::landmark)
            == 0)
            points.push_back(
                {.name = QString::fromStdString(landmark.name), .p_AQ = landmark.p_AQ});
    const SiteVerification checked = site.verification.value_or(SiteVerification{});
    for (const VerifiedPoint& point : checked.points) {
        const QString name = QString::fromStdString(point.name);
        auto known = std::ranges::find(points, name, &CheckPoint::name);
        if (known == points.end())
            known = points.insert(points.end(), {.name = name, .p_AQ = point.p_AQ});
        if (!checked.stale)
            known->error_mm = inMillimetres(metres(point.error));
    }
    for (const CheckPoint& picked : m_picked)
        if (std::ranges::count(points, picked.name, &CheckPoint::name) == 0)
            points.push_back(picked);
    return points;
}

std::optional<std::size_t> VerifyTask::next() const
{
    const std::vector<CheckPoint> all = places();
    if (m_chosen && *m_chosen < all.size())
        return m_chosen;
    const auto open =
        std::ranges::find_if(all, [](const CheckPoint& point) { return !point.error_mm; });
    return open == all.end() ? std::nullopt : std::optional{std::size_t(open - all.begin())};
}

void VerifyTask::choose(std::optional<std::size_t> point)
{
    m_chosen = point;
    m_watch.restart();
    Q_EMIT m_editor.changed();
}

void VerifyTask::pick(const Vec3& p_A_eye, const Vec3& dir_A)
{
    const auto place = m_surfaces.picked(p_A_eye, dir_A, true);
    if (!place)
        return m_editor.refuse(
            VerifyWords::tr("There is nothing of the patient at that place: click on the model."));
    const std::vector<CheckPoint> known = places();
    QString name;
    for (int number = 1; name.isEmpty() || std::ranges::count(known, name, &CheckPoint::name) > 0;
         ++number)
        name = VerifyWords::tr("Place %1").arg(number);
    m_picked.push_back({.name = name, .p_AQ = *place});
    choose(known.size());
}

bool VerifyTask::hasPicked() const { return !m_picked.empty() && !isTouched(m_picked.back()); }

void VerifyTask::dropPicked()
{
    m_picked.pop_back();
    choose(std::nullopt);
}

bool VerifyTask::isTouched(const CheckPoint& point) const
{
    const auto& verification = m_editor.site().verification;
    return verification
           && std::ranges::count(verification->points, point.name.toStdString(),
                                 &VerifiedPoint::name)
                  > 0;
}

void VerifyTask::take(const StylusTouch& touch)
{
    if (!next())
        return;
    const CheckPoint point = places()[*next()];
    const Vec3 p_AQ = m_editor.site().registration->X_AT * touch.point.p_FQ;
    const Length off = metres((p_AQ - point.p_AQ).norm());
    if (off > kFarthestCheck)
        return m_editor.refuse(VerifyWords::tr("The tip is %1\u00a0mm from where %2 is drawn: hold "
                                               "it there. If the manikin was moved, lay it anew.")
                                   .arg(inMillimetres(off), 0, 'f', 0)
                                   .arg(point.name));
    if (m_editor.become(
            withVerified(m_editor.site(), {.name = point.name.toStdString(),
                                           .p_AQ = point.p_AQ,
                                           .p_TQ = touch.point.p_FQ,
                                           .error = off.si,
                                           .bound = boundAt(point.p_AQ, kBoundShare)}))) {
        m_chosen.reset();
        m_editor.tell(
            VerifyWords::tr("%1: %2 mm").arg(point.name).arg(inMillimetres(off), 0, 'f', 1));
        Q_EMIT m_editor.changed();
    }
}

bool VerifyTask::canJudge() const
{
    const auto& registration = m_editor.site().registration;
    return registration && registration->degrees > 0.0;
}

double VerifyTask::boundAt(const Vec3& p_AQ, double share) const
{
    const SiteRegistration& registration = *m_editor.site().registration;
    const double ofTouch = registration.fle * registration.fle / 3.0;
    const Mat3 covariance =
        pointCovariance(registration.covariance_A, p_AQ) + ofTouch * Mat3::Identity();
    return errorBound(covariance, registration.degrees, share).si;
}

bool VerifyTask::isComplete() const
{
    const std::vector<CheckPoint> all = places();
    return !all.empty() && std::ranges::all_of(all, [](const CheckPoint& point) {
        return point.error_mm.has_value();
    });
}

bool VerifyTask::hasAirwayPoint() const
{
    const auto& verification = m_editor.site().verification;
    const AirwayLandmarks& airway = m_patient.landmarks();
    const double margin = 0.5 * (airway.p_A_glottis.z() - airway.p_A_carina.z());
    const double lowest = airway.p_A_glottis.z() - margin;
    const double highest = std::max(airway.p_A_incisors.z(), airway.p_A_glottis.z()) + margin;
    return verification
           && std::ranges::any_of(verification->points, [&](const VerifiedPoint& point) {
                  return point.p_AQ.z() >= lowest && point.p_AQ.z() <= highest;
              });
}

Verdict VerifyTask::suggestion() const
{
    const auto& verification = m_editor.site().verification;
    if (!canJudge() || !verification || verification->stale
        || verification->points.size() < kFewestPoints)
        return Verdict::Open;
    const bool all = std::ranges::all_of(verification->points,
                                         [share = shareOfOne(), this](const VerifiedPoint& point) {
                                             return point.error <= boundAt(point.p_AQ, share);
                                         });
    return all ? Verdict::Good : Verdict::NotGood;
}

std::size_t VerifyTask::touched() const
{
    const auto& verification = m_editor.site().verification;
    return verification && !verification->stale ? verification->points.size() : 0;
}

/// Together 95 %, as if they were independent.
double VerifyTask::shareOfOne() const
{
    return std::pow(kBoundShare, 1.0 / double(std::max<std::size_t>(touched(), 1)));
}

bool VerifyTask::isRecorded() const
{
    const auto& verification = m_editor.site().verification;
    return verification && !verification->stale && verification->verdict != Verdict::Open;
}

void VerifyTask::record(Verdict verdict)
{
    CARINA_EXPECTS(suggestion() != Verdict::Open);
    m_editor.become(withVerdict(m_editor.site(), verdict, m_editor.now()));
}

} // namespace carina
