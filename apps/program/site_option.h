#pragma once

#include "models/site/site_setup.h"

#include <QCommandLineParser>
#include <QObject>

#include <functional>

namespace carina::program
{

/// Adds `--site FILE`.
void addSiteOption(QCommandLineParser& parser);

/// The site that `--site` names; nothing without it.
/// @returns what readSiteFile and siteSetup refuse, with the file's name.
[[nodiscard]] Result<std::optional<SiteSetup>> siteOption(const QCommandLineParser& parser,
                                                          const PatientModel& patient);

/// Calls back whenever the file that `--site` names was written anew. @pre context outlives neither
/// the callback nor what it uses.
void watchSite(const QCommandLineParser& parser, QObject& context,
               const std::function<void()>& written);

} // namespace carina::program
