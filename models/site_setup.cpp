#include "models/site_setup.h"

namespace carina
{

namespace
{

std::optional<GuardedRegistration> guardOf(const Site& site)
{
    const SiteRegistration& fitted = *site.registration;
    if (fitted.degrees == 0.0 || site.styluses.empty())
        return std::nullopt;
    return GuardedRegistration{.p_SQ = site.styluses.back().p_SQ,
                               .landmarks = site.catalogue->landmarks,
                               .covariance_A = fitted.covariance_A,
                               .fle = metres(fitted.fle)};
}

} // namespace

Result<SiteSetup> siteSetup(const Site& site, const PatientModel& patient)
{
    if (!site.registration || !site.catalogue || site.registration->stale == StaleCause::Tracker)
        return fail(Errc::NotRegistered, "");
    const std::string& anatomy = site.catalogue->anatomy;
    if (!anatomy.empty() && anatomy != patient.contentHash())
        return fail(Errc::OtherPatient, "");
    const SiteRegistration& fitted = *site.registration;
    Result<SiteSetup> setup = SiteSetup{};
    setup->registration.X_AT = fitted.X_AT;
    setup->display = site.display;
    if (fitted.X_JM)
        setup->registration.X_JA = *fitted.X_JM * fitted.X_AM.inverse();
    if (fitted.X_BM)
        setup->registration.X_BA = *fitted.X_BM * fitted.X_AM.inverse();
    setup->guard = guardOf(site);
    return setup;
}

} // namespace carina
