#include "apps/program/options/site_option.h"

#include "engine/io/site/site_file.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QFileSystemWatcher>

namespace carina::program
{
namespace
{

const QString kSiteFile = QStringLiteral("site");

} // namespace

void addSiteOption(QCommandLineParser& parser, const QString& more)
{
    QString meaning = QCoreApplication::translate(
        "Program",
        "Align the patient with the manikin by the registration in this file of "
        "carina-registration; without it the simulated manikin is registered without error.");
    if (!more.isEmpty())
        meaning += QLatin1Char{' '} + more;
    parser.addOption({kSiteFile, meaning, QStringLiteral("FILE")});
}

QString siteOption(const QCommandLineParser& parser) { return parser.value(kSiteFile); }

Result<std::optional<SitePlace>> siteIn(const QString& file, const PatientModel& patient,
                                        const QString& tracker)
{
    if (file.isEmpty())
        return std::nullopt;
    const Result<Site> site = readSiteFile(file.toStdString());
    if (!site)
        return tl::unexpected(site.error());
    return std::optional{sitePlace(*site, patient, tracker, QDateTime::currentDateTimeUtc())};
}

void watchSite(const QString& file, QObject& context, const std::function<void()>& written)
{
    if (file.isEmpty())
        return;
    QFileInfo site{file};
    // The folder: a file that is written whole takes the place of the one before.
    auto* watcher = new QFileSystemWatcher{{site.absolutePath()}, &context};
    // Of a file that is gone there is no time.
    auto look = [site, written, last = site.lastModified()]() mutable {
        site.refresh();
        if (site.lastModified() == last)
            return;
        last = site.lastModified();
        written();
    };
    QObject::connect(watcher, &QFileSystemWatcher::directoryChanged, &context, look);
}

} // namespace carina::program
