#pragma once

#include "engine/io/site/site_file.h"
#include "engine/session/station_tracking.h"
#include "models/patient/patient_model.h"
#include "models/registration/registration_guard.h"
#include "models/site/site_standing.h"

namespace carina
{

/// The registration of a station from its site file.
struct SiteSetup {
    StationRegistration registration;
    /// For monitoring the registration; std::nullopt if its error is unknown.
    std::optional<GuardedRegistration> guard{};
    std::optional<TubeRest> tube{};    ///< the shape of the tube, where it is calibrated
    std::optional<BladeShape> blade{}; ///< likewise of the laryngoscope
};

/// A site as a station uses it.
struct SitePlace {
    RegistrationStanding standing;            ///< how far its registration can be relied on
    std::optional<SiteSetup> setup{};         ///< nothing where there is none that can be used
    std::optional<DisplayGeometry> display{}; ///< of the headset, if it was measured
};

/// Whether both place the anatomy alike; a site file also changes for other reasons.
[[nodiscard]] bool isSamePlace(const SiteSetup& a, const SiteSetup& b);

/// Whether both draw the same tube and laryngoscope.
[[nodiscard]] bool areSameTools(const SiteSetup& a, const SiteSetup& b);

/// Whether both have the same data for monitoring.
[[nodiscard]] bool isSameGuard(const SiteSetup& a, const SiteSetup& b);

/// Checks that a site is for this patient, or for none yet.
/// @returns OtherPatient; the detail names both patients if the site names its own.
[[nodiscard]] Result<void> checkPatient(const Site& site, const PatientModel& patient);

/// @returns NotRegistered before the fit; the error of checkPatient.
[[nodiscard]] Result<SiteSetup> siteSetup(const Site& site, const PatientModel& patient);

/// @param tracker name of the present tracker; empty where it is not known
[[nodiscard]] SitePlace sitePlace(const Site& site, const PatientModel& patient,
                                  const QString& tracker, const QDateTime& today);

} // namespace carina
