#include "engine/io/site/site_station.h"

namespace carina
{

const SiteTool* usableTool(const Site& site, ToolRole role)
{
    const SiteTool* tool = toolOfRole(site.tools, role);
    return tool != nullptr && tool->stale != StaleCause::Tracker ? tool : nullptr;
}

Result<void> checkPatient(const Site& site, const std::string& name, const std::string& contentHash)
{
    const std::string anatomy = site.catalogue ? site.catalogue->anatomy : std::string{};
    if (anatomy.empty() || anatomy == contentHash)
        return {};
    const std::string here = "the patient here is \"" + name + '"';
    return fail(Errc::OtherPatient,
                site.patient.empty() ? here : "it is of \"" + site.patient + "\", " + here);
}

Result<StationRegistration> stationRegistration(const Site& site)
{
    if (!site.registration || !site.catalogue || site.registration->stale == StaleCause::Tracker)
        return fail(Errc::NotRegistered, "");
    const SiteRegistration& fitted = *site.registration;
    StationRegistration registration{.X_AT = fitted.X_AT};
    if (fitted.X_JM)
        registration.X_JA = *fitted.X_JM * fitted.X_AM.inverse();
    if (fitted.X_BM)
        registration.X_BA = *fitted.X_BM * fitted.X_AM.inverse();
    if (const SiteTool* tube = usableTool(site, ToolRole::Tube))
        registration.X_NE = tube->X_NO;
    if (const SiteTool* laryngoscope = usableTool(site, ToolRole::Laryngoscope))
        registration.X_NL = laryngoscope->X_NO;
    return registration;
}

} // namespace carina
