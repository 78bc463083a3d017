#include "ui/registration/registration_paper.h"

#include "ui/registration/local_time.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

class PaperWords
{
    Q_DECLARE_TR_FUNCTIONS(RegistrationPaper)
};

double inMillimetresOf(double length) { return inMillimetres(metres(length)); }

std::optional<RegistrationReport::Stylus> stylusOf(const StylusTip* tip)
{
    if (!tip)
        return std::nullopt;
    return RegistrationReport::Stylus{.rms_mm = inMillimetresOf(tip->rms),
                                      .uncertainty_mm =
                                          inMillimetresOf(std::sqrt(tip->covariance_S.trace())),
                                      .poses = tip->poses,
                                      .date = localTime(tip->calibratedAt)};
}

std::vector<RegistrationReport::Landmark> landmarksOf(const RegistrationModel& registration)
{
    const SiteRegistration& fitted = *registration.site().registration;
    const double share = 1.0 - 2.0 / double(std::max<std::size_t>(3, fitted.residuals.size()));
    std::vector<RegistrationReport::Landmark> landmarks;
    for (const LandmarkRow& row : registration.landmarks())
        landmarks.push_back({.name = row.name,
                             .spread_mm = row.spread_mm,
                             .residual_mm = row.residual_mm,
                             .expected_mm = std::sqrt(share) * inMillimetresOf(fitted.fle),
                             .leftOut_mm = row.leftOut_mm});
    return landmarks;
}

QStringList staleTasks(const RegistrationModel& registration)
{
    QStringList sentences;
    for (const SiteStep step :
         {SiteStep::Tracker, SiteStep::Touch, SiteStep::Fit, SiteStep::Verify})
        if (const SiteTask task = registration.task(step); task.state == TaskState::Stale)
            sentences << QStringLiteral("%1: %2").arg(stepTitle(step), task.why);
    return sentences;
}

RegistrationReport::Verdict verdictOf(const Site& site)
{
    if (!site.verification || site.verification->stale)
        return RegistrationReport::Verdict::NotVerified;
    switch (site.verification->verdict) {
    case Verdict::Open:
        return RegistrationReport::Verdict::NotVerified;
    case Verdict::Good:
        return RegistrationReport::Verdict::Verified;
    case Verdict::NotGood:
        return RegistrationReport::Verdict::NotGoodEnough;
    }
    return RegistrationReport::Verdict::NotVerified;
}

QString named(const std::string& person)
{
    return person.empty() ? PaperWords::tr("not named") : QString::fromStdString(person);
}

QString manikinOf(const Site& site)
{
    return site.manikin.profile ? QString::fromStdString(site.manikin.profile->name) : QString{};
}

QString judgedIn(const Site& site)
{
    if (verdictOf(site) == RegistrationReport::Verdict::NotVerified)
        return {};
    const QString at = localTime(site.verification->at);
    const std::string& person = site.verification->operatorName;
    return person.empty() ? PaperWords::tr("%1, operator not named").arg(at)
                          : PaperWords::tr("%1, by %2").arg(at, QString::fromStdString(person));
}

/// The places beyond their own bounds beside a verdict that is good, which judges all together.
QStringList toleratedIn(const Site& site)
{
    QStringList sentences;
    if (verdictOf(site) != RegistrationReport::Verdict::Verified)
        return sentences;
    for (const VerifiedPoint& point : site.verification->points)
        if (point.error > point.bound)
            sentences << PaperWords::tr("%1: its error is above its own 95 % bound. The verdict is "
                                        "about all places together; by chance one place in twenty "
                                        "is above its bound.")
                             .arg(QString::fromStdString(point.name));
    return sentences;
}

void addChecked(const Site& site, RegistrationReport& report)
{
    if (!site.verification || site.verification->stale)
        return;
    for (const VerifiedPoint& point : site.verification->points)
        report.checked.push_back({.name = QString::fromStdString(point.name),
                                  .error_mm = inMillimetresOf(point.error),
                                  .bound_mm = inMillimetresOf(point.bound)});
}

void addTargets(const std::vector<ExpectedError>& expected, RegistrationReport& report)
{
    for (const ExpectedError& error : expected) {
        report.targets.push_back({.name = error.name,
                                  .rms_mm = error.rms_mm,
                                  .bound_mm = error.bound_mm,
                                  .weakestDirection = error.weakest});
        report.bound_mm = std::max(report.bound_mm.value_or(0.0), error.bound_mm);
    }
}

} // namespace

RegistrationReport reportOf(const RegistrationModel& registration, QImage picture)
{
    const Site& site = registration.site();
    const SiteRegistration& fitted = *site.registration;
    RegistrationReport report{
        .siteFile = QString::fromStdString(registration.siteFile().filename().string()),
        .patient = QString::fromStdString(registration.patient().name()),
        .manikin = manikinOf(site),
        .tracker = registration.trackerName(),
        .operatorName = named(fitted.operatorName),
        .date = localTime(fitted.madeAt),
        .verdict = verdictOf(site),
        .judged = judgedIn(site),
        .notes = registration.fitting().findings() + staleTasks(registration) + toleratedIn(site)
                 + registration.manikin().comparison(),
        .landmarks = landmarksOf(registration),
        .fre_mm = inMillimetresOf(fitted.rms),
        .stylus = stylusOf(registration.stylus().tip()),
        .picture = std::move(picture),
        .caption = PaperWords::tr("Expected error on the anatomy, root mean square")};
    if (const auto fle = registration.fitting().localisation())
        report.fle = RegistrationReport::Localisation{.rms_mm = inMillimetres(fle->rms),
                                                      .limit_mm = inMillimetres(fle->limit)};
    addChecked(site, report);
    addTargets(registration.fitting().expected(), report);
    return report;
}

} // namespace carina
