#pragma once

#include "models/site/site_setup.h"

#include <QCommandLineParser>
#include <QObject>

#include <functional>

namespace carina::program
{

/// Adds `--site FILE`.
void addSiteOption(QCommandLineParser& parser);

/// The site named by `--site`; std::nullopt without it.
/// @returns the errors of readSiteFile and siteSetup, with the file's name.
[[nodiscard]] Result<std::optional<SiteSetup>> siteOption(const QCommandLineParser& parser,
                                                          const PatientModel& patient);

/// Calls `written` whenever the file named by `--site` was rewritten, until `context` is destroyed.
/// @pre what the callback uses outlives `context`.
void watchSite(const QCommandLineParser& parser, QObject& context,
               const std::function<void()>& written);

} // namespace carina::program
