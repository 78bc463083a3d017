#pragma once

#include "engine/io/site/site_file.h"
#include "engine/session/station_tracking.h"
#include "models/patient/patient_model.h"
#include "models/registration/registration_guard.h"

namespace carina
{

/// What a station takes from its site file.
struct SiteSetup {
    StationRegistration registration;
    /// What to watch it by; nothing where its error is not known.
    std::optional<GuardedRegistration> guard{};
    std::optional<DisplayGeometry> display{}; ///< of the headset, if it was measured
};

/// Whether both lay the anatomy alike: a site is also written for other things.
[[nodiscard]] bool isSamePlace(const SiteSetup& a, const SiteSetup& b);

/// Whether both are watched by the same.
[[nodiscard]] bool isSameGuard(const SiteSetup& a, const SiteSetup& b);

/// Whether a site is of this patient, or of none yet.
/// @returns OtherPatient; the detail names both, where the site names its own.
[[nodiscard]] Result<void> checkPatient(const Site& site, const PatientModel& patient);

/// @returns NotRegistered before the site's anatomy was fitted; what checkPatient returns.
[[nodiscard]] Result<SiteSetup> siteSetup(const Site& site, const PatientModel& patient);

} // namespace carina
