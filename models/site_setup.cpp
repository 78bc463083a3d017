#include "models/site_setup.h"

namespace carina
{

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
    return setup;
}

} // namespace carina
