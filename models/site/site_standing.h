#pragma once

#include "engine/io/site/site.h"
#include "engine/session/facts/registration_facts.h"

#include <QDateTime>
#include <QString>

#include <optional>

namespace carina
{

/// What the registration of a site is judged by.
struct SiteCircumstances {
    std::string anatomy{}; ///< content hash of the present patient; empty: not judged
    QString tracker{};     ///< name of the present tracker; empty: not judged
    QDateTime today{};     ///< an old verification does not count
    /// The glottis of the patient, for the expected error.
    std::optional<Vec3> p_A_glottis{};
};

/// How far the registration of a site can be relied on: the one judgement, which the wizard and a
/// trainee's program share. The weightiest holds: no registration, another patient, another
/// tracker, being registered again, stale by a change, not or no longer verified, judged not good,
/// verified too long ago.
[[nodiscard]] RegistrationStanding siteStanding(const Site& site, const SiteCircumstances& here);

/// The registration where landmarks were found by so much (metres) from their places.
[[nodiscard]] RegistrationStanding driftedBy(double shift);

[[nodiscard]] StaleReason reasonOf(StaleCause cause);

/// Whether an ISO 8601 time is more than 30 days ago; false where it is not known.
[[nodiscard]] bool isLongAgo(const std::string& time, const QDateTime& today);

} // namespace carina
