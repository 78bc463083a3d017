#pragma once

#include "models/site/site_setup.h"

#include <QCommandLineParser>
#include <QObject>

#include <functional>

namespace carina::program
{

/// Adds `--site FILE`.
void addSiteOption(QCommandLineParser& parser);

/// Whether `--site` is given.
[[nodiscard]] bool hasSite(const QCommandLineParser& parser);

/// The site named by `--site`, as of now; std::nullopt without it.
/// @param tracker trackerIdentity of the present one; empty where it is not known
/// @returns the errors of readSiteFile.
[[nodiscard]] Result<std::optional<SitePlace>>
siteOption(const QCommandLineParser& parser, const PatientModel& patient, const QString& tracker);

/// Calls `written` whenever the file named by `--site` was rewritten, until `context` is destroyed.
/// @pre what the callback uses outlives `context`.
void watchSite(const QCommandLineParser& parser, QObject& context,
               const std::function<void()>& written);

} // namespace carina::program
