#pragma once

#include "engine/io/site/site.h"
#include "engine/session/station_tracking.h"

namespace carina
{

/// The calibration of the site's tool with this role; nullptr where there is none, or where it was
/// made with another tracker, whose markers may be others.
[[nodiscard]] const SiteTool* usableTool(const Site& site, ToolRole role);

/// Checks that a site is for this patient, or for none yet.
/// @returns OtherPatient; the detail names both patients if the site names its own.
[[nodiscard]] Result<void> checkPatient(const Site& site, const std::string& name,
                                        const std::string& contentHash);

/// The registration of a station by its site, with tube and laryngoscope where they are usable.
/// @returns NotRegistered before the fit, and where it was made with another tracker.
[[nodiscard]] Result<StationRegistration> stationRegistration(const Site& site);

} // namespace carina
