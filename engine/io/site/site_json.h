#pragma once

#include "engine/io/files/json_fields.h"
#include "engine/io/site/site.h"

#include <array>

namespace carina
{

/// The fields of a site file (site_file.h), and the words in it.
inline const QString kSiteSchema = QStringLiteral("carina.site/2");
inline const QString kFirstSiteSchema = QStringLiteral("carina.site/1");
inline constexpr std::array kStepWords{"overview", "tracker", "stylus", "landmarks",
                                       "touch",    "fit",     "verify"};
inline constexpr std::array kStaleWords{"tracker", "stylus",  "landmarks",
                                        "manikin", "touches", "fit"};
inline constexpr std::array kVerdictWords{"open", "good", "not good"};

/// Milliradians and millimetres, squared: what a covariance of turns and shifts is in the file.
inline constexpr double kCovarianceUnit = 1e-6;

[[nodiscard]] QJsonObject jsonSite(const Site& site);

/// A site of fields; the first fault is in them.
[[nodiscard]] Site readSite(JsonFields& fields);

} // namespace carina
