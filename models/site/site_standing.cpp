#include "models/site/site_standing.h"

#include "engine/registration/error/target_error.h"

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

constexpr qint64 kOld_days = 30;

constexpr double kLargest_mm = 1000.0; ///< as a fact may have it

/// In tenths of a millimetre, as facts and screens have it.
Length rounded(Length length)
{
    return millimetres(std::min(kLargest_mm, std::round(10.0 * inMillimetres(length)) / 10.0));
}

RegistrationStanding stale(StaleReason reason) { return {RegistrationState::Stale, reason, {}}; }

/// 0 where the site does not tell.
Length expectedError(const SiteRegistration& registration, const SiteCircumstances& here)
{
    const bool isKnown = here.p_A_glottis && registration.degrees > 0.0;
    if (!isKnown)
        return {};
    return rounded(
        targetError(registration.covariance_A, *here.p_A_glottis, registration.degrees).bound);
}

Length largestError(const SiteVerification& verification)
{
    double largest = 0.0;
    for (const VerifiedPoint& point : verification.points)
        largest = std::max(largest, point.error);
    return rounded(metres(largest));
}

bool isOfAnotherPatient(const Site& site, const SiteCircumstances& here)
{
    return site.catalogue && !site.catalogue->anatomy.empty() && !here.anatomy.empty()
           && site.catalogue->anatomy != here.anatomy;
}

bool isOfAnotherTracker(const Site& site, const SiteCircumstances& here)
{
    const bool isRenamed = !site.tracker.empty() && !here.tracker.isEmpty()
                           && site.tracker != here.tracker.toStdString();
    return isRenamed || site.registration->stale == StaleCause::Tracker;
}

} // namespace

RegistrationStanding siteStanding(const Site& site, const SiteCircumstances& here)
{
    if (!site.registration)
        return {RegistrationState::Missing, StaleReason::None, {}};
    if (isOfAnotherPatient(site, here))
        return stale(StaleReason::Patient);
    if (isOfAnotherTracker(site, here))
        return stale(StaleReason::Tracker);
    if (site.relay)
        return stale(StaleReason::Registering);
    if (site.registration->stale)
        return stale(reasonOf(*site.registration->stale));
    const Length expected = expectedError(*site.registration, here);
    if (site.verification && site.verification->stale)
        return {RegistrationState::Unverified, reasonOf(*site.verification->stale), expected};
    if (!site.verification || site.verification->verdict == Verdict::Open)
        return {RegistrationState::Unverified, StaleReason::None, expected};
    if (site.verification->verdict == Verdict::NotGood)
        return {RegistrationState::NotGood, StaleReason::None, largestError(*site.verification)};
    if (isLongAgo(site.verification->at, here.today))
        return stale(StaleReason::Age);
    return {RegistrationState::Good, StaleReason::None, expected};
}

RegistrationStanding driftedBy(double shift)
{
    return {RegistrationState::Stale, StaleReason::Drift,
            millimetres(std::min(kLargest_mm, std::round(inMillimetres(metres(shift)))))};
}

StaleReason reasonOf(StaleCause cause)
{
    switch (cause) {
    case StaleCause::Tracker:
        return StaleReason::Tracker;
    case StaleCause::Stylus:
        return StaleReason::Stylus;
    case StaleCause::Landmarks:
        return StaleReason::Landmarks;
    case StaleCause::Manikin:
        return StaleReason::Manikin;
    case StaleCause::Touches:
        return StaleReason::Touches;
    case StaleCause::Fit:
        return StaleReason::Fit;
    }
    return StaleReason::None;
}

bool isLongAgo(const std::string& time, const QDateTime& today)
{
    const auto then = QDateTime::fromString(QString::fromStdString(time), Qt::ISODate);
    return then.isValid() && then.daysTo(today) > kOld_days;
}

} // namespace carina
