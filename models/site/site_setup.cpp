#include "models/site/site_setup.h"

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

/// The tools as they were calibrated; with another tracker their markers may be others.
void addTools(SiteSetup& setup, const std::vector<SiteTool>& tools)
{
    for (const SiteTool& tool : tools) {
        if (tool.stale == StaleCause::Tracker)
            continue;
        if (tool.role == ToolRole::Tube) {
            setup.registration.X_NE = tool.X_NO;
            setup.tube = tool.tube;
        } else {
            setup.registration.X_NL = tool.X_NO;
            setup.blade = tool.blade;
        }
    }
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
    const std::string anatomy = site.catalogue ? site.catalogue->anatomy : std::string{};
    if (anatomy.empty() || anatomy == patient.contentHash())
        return {};
    const std::string here = "the patient here is \"" + patient.name() + '"';
    return fail(Errc::OtherPatient,
                site.patient.empty() ? here : "it is of \"" + site.patient + "\", " + here);
}

Result<SiteSetup> siteSetup(const Site& site, const PatientModel& patient)
{
    if (!site.registration || !site.catalogue || site.registration->stale == StaleCause::Tracker)
        return fail(Errc::NotRegistered, "");
    if (const auto isOf = checkPatient(site, patient); !isOf)
        return tl::unexpected(isOf.error());
    const SiteRegistration& fitted = *site.registration;
    Result<SiteSetup> setup = SiteSetup{};
    setup->registration.X_AT = fitted.X_AT;
    if (fitted.X_JM)
        setup->registration.X_JA = *fitted.X_JM * fitted.X_AM.inverse();
    if (fitted.X_BM)
        setup->registration.X_BA = *fitted.X_BM * fitted.X_AM.inverse();
    setup->guard = guardOf(site);
    addTools(*setup, site.tools);
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
