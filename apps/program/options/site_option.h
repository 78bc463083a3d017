#pragma once

#include "models/site/site_setup.h"

#include <QCommandLineParser>
#include <QObject>

#include <functional>

namespace carina::program
{

/// Adds `--site FILE`.
/// @param more that the program does with it, as sentences
void addSiteOption(QCommandLineParser& parser, const QString& more = {});

/// The file that `--site` names; empty without it.
[[nodiscard]] QString siteOption(const QCommandLineParser& parser);

/// The site in a file, as of now; std::nullopt for an empty name.
/// @param tracker trackerIdentity of the present one; empty where it is not known
/// @returns the errors of readSiteFile.
[[nodiscard]] Result<std::optional<SitePlace>>
siteIn(const QString& file, const PatientModel& patient, const QString& tracker);

/// Calls `written` whenever the file was written or removed, until `context` is destroyed.
/// @pre what the callback uses outlives `context`.
void watchSite(const QString& file, QObject& context, const std::function<void()>& written);

} // namespace carina::program
