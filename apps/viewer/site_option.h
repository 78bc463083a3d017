#pragma once

#include "models/site_setup.h"

#include <QCommandLineParser>

namespace carina::viewer
{

/// Adds `--site FILE`.
void addSiteOption(QCommandLineParser& parser);

/// The site that `--site` names; nothing without it.
/// @returns what readSiteFile and siteSetup refuse, with the file's name.
[[nodiscard]] Result<std::optional<SiteSetup>> siteOption(const QCommandLineParser& parser,
                                                          const PatientModel& patient);

} // namespace carina::viewer
