#pragma once

#include "engine/io/files/json_fields.h"
#include "engine/io/site/site.h"

#include <array>

namespace carina
{

/// The schema of a site file (site_file.h), and the words for its enumerators, in their order.
inline const QString kSiteSchema = QStringLiteral("carina.site/6");
/// Versions before that have a digest too: /5 has no devices, /4 no tools either.
inline const std::array kEarlierSchemasWithDigest{QStringLiteral("carina.site/5"),
                                                  QStringLiteral("carina.site/4")};
/// Versions that are read too: /3 has no digest, /2 no manikin and no localisations either, /1 one
/// "stylus" and fewer fields.
inline const std::array kEarlierSiteSchemas{
    kEarlierSchemasWithDigest[0], kEarlierSchemasWithDigest[1], QStringLiteral("carina.site/3"),
    QStringLiteral("carina.site/2"), QStringLiteral("carina.site/1")};
inline constexpr std::array kStepWords{"overview", "tracker", "stylus", "landmarks",
                                       "touch",    "fit",     "verify", "tools"};
inline constexpr std::array kStaleWords{"tracker", "stylus",  "landmarks",
                                        "manikin", "touches", "fit"};
inline constexpr std::array kVerdictWords{"open", "good", "not good"};

/// Squared unit of a covariance in the file: milliradians and millimetres.
inline constexpr double kCovarianceUnit = 1e-6;

[[nodiscard]] QJsonObject jsonSite(const Site& site);

/// A site from its fields; the first fault is kept in them.
[[nodiscard]] Site readSite(JsonFields& fields);

} // namespace carina
