#include "models/site/site_setup.h"

#include "engine/io/site/site_station.h"

#include <algorithm>

namespace carina
{

namespace
{

std::optional<GuardedRegistration> guardOf(const Site& site)
{
    const SiteRegistration& fitted = *site.registration;
    const bool isErrorKnown =
        fitted.degrees > 0.0 && fitted.fle > 0.0 && isPositiveDefinite(fitted.covariance_A);
    if (!isErrorKnown || site.styluses.empty())
        return std::nullopt;
    return GuardedRegistration{.styluses = site.styluses,
                               .landmarks = site.catalogue->landmarks,
                               .covariance_A = fitted.covariance_A,
                               .fle = metres(fitted.fle)};
}

bool isSame(const RigidTransform& a, const RigidTransform& b)
{
    return a.translation() == b.translation() && a.rotation().coeffs() == b.rotation().coeffs();
}

bool isSame(const std::optional<RigidTransform>& a, const std::optional<RigidTransform>& b)
{
    return a && b ? isSame(*a, *b) : a.has_value() == b.has_value();
}

} // namespace

bool isSamePlace(const SiteSetup& a, const SiteSetup& b)
{
    return isSame(a.registration.X_AT, b.registration.X_AT)
           && isSame(a.registration.X_JA, b.registration.X_JA)
           && isSame(a.registration.X_BA, b.registration.X_BA)
           && isSame(a.registration.X_NE, b.registration.X_NE)
           && isSame(a.registration.X_NL, b.registration.X_NL);
}

bool areSameTools(const SiteSetup& a, const SiteSetup& b)
{
    return a.tube == b.tube && a.blade == b.blade;
}

bool isSameGuard(const SiteSetup& a, const SiteSetup& b)
{
    if (!a.guard || !b.guard)
        return a.guard.has_value() == b.guard.has_value();
    const auto isSameTip = [](const StylusTip& one, const StylusTip& other) {
        return one.tool == other.tool && one.p_SQ == other.p_SQ;
    };
    return a.guard->covariance_A == b.guard->covariance_A && a.guard->fle.si == b.guard->fle.si
           && a.guard->landmarks == b.guard->landmarks
           && std::ranges::equal(a.guard->styluses, b.guard->styluses, isSameTip);
}

Result<void> checkPatient(const Site& site, const PatientModel& patient)
{
    return checkPatient(site, patient.name(), patient.contentHash());
}

Result<SiteSetup> siteSetup(const Site& site, const PatientModel& patient)
{
    const auto registration = stationRegistration(site);
    if (!registration)
        return tl::unexpected(registration.error());
    if (const auto isOf = checkPatient(site, patient); !isOf)
        return tl::unexpected(isOf.error());
    SiteSetup setup{.registration = *registration, .guard = guardOf(site)};
    if (const SiteTool* tube = usableTool(site, ToolRole::Tube))
        setup.tube = tube->tube;
    if (const SiteTool* laryngoscope = usableTool(site, ToolRole::Laryngoscope))
        setup.blade = laryngoscope->blade;
    return setup;
}

SitePlace sitePlace(const Site& site, const PatientModel& patient, const QString& tracker,
                    const QDateTime& today)
{
    SitePlace place{.standing =
                        siteStanding(site, {.anatomy = patient.contentHash(),
                                            .tracker = tracker,
                                            .today = today,
                                            .p_A_glottis = patient.landmarks().p_A_glottis}),
                    .display = site.display};
    if (const auto setup = siteSetup(site, patient))
        place.setup = *setup;
    return place;
}

} // namespace carina
