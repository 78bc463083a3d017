#include "models/session/readiness.h"

#include "engine/core/disciplined_clock.h"
#include "engine/io/site/site_file.h"
#include "models/errors/error_text.h"
#include "models/patient/patient_model.h"
#include "models/site/site_standing.h"
#include "models/site/standing_words.h"
#include "models/tracker/tracker_choice.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QLocale>
#include <QStorageInfo>

namespace carina
{
namespace
{

/// A session of a day with its records is far below this.
constexpr qint64 kLowDisk_bytes = 1'000'000'000;

class ReadyWords
{
    Q_DECLARE_TR_FUNCTIONS(carina::Readiness)

public:
    static QString age(const std::string& time, const QDateTime& today)
    {
        const auto then = QDateTime::fromString(QString::fromStdString(time), Qt::ISODate);
        if (!then.isValid())
            return tr("at an unknown time");
        const qint64 days = then.daysTo(today);
        return days < 1 ? tr("today") : tr("%n days ago", nullptr, int(days));
    }

    /// No tracker is asked here: only the simulated one is known to be there.
    static QString tracker(const QString& siteFile, const Site& site)
    {
        if (!site.devices.empty())
            return devices(trackerOfSite(siteFile.toStdString()));
        const QString described =
            QFileInfo{siteFile}.absoluteDir().filePath(QStringLiteral("tracker.json"));
        if (!QFileInfo::exists(described))
            return registeredWith(QString::fromStdString(site.tracker));
        const auto choice = describedIn(described.toStdString());
        return choice ? tr("○ %1 is described, and was not asked yet; a trainee's program "
                           "connects to it")
                            .arg(trackerName(*choice))
                      : tr("▲ %1").arg(errorText(choice.error()));
    }

    /// @param name of the tracker, as the site has it
    static QString registeredWith(const QString& name)
    {
        if (name.isEmpty())
            return tr("○ none is chosen yet: carina-registration asks for it");
        if (name == trackerIdentity(TrackerChoice{SimulatedDevice{}}))
            return tr("✓ %1: a part of this program").arg(name);
        return tr("○ %1, with which the site was registered, was not asked yet").arg(name);
    }

    static QString devices(const Result<std::optional<TrackerChoice>>& named)
    {
        if (!named)
            return tr("▲ %1").arg(errorText(named.error()));
        return tr("○ %1: the site names it, and it was not asked yet; a trainee's program connects "
                  "to it")
            .arg(*named ? trackerName(**named) : QString{});
    }

    static QString registration(const Site& site, const ReadinessQuestion& asked)
    {
        SiteCircumstances here{.today = asked.today};
        if (asked.patient) {
            here.anatomy = asked.patient->contentHash();
            here.p_A_glottis = asked.patient->landmarks().p_A_glottis;
        }
        const RegistrationStanding standing = siteStanding(site, here);
        QString told = standingText(standing);
        if (site.registration)
            told = tr("%1; made %2", "how a registration stands; its age")
                       .arg(told, age(site.registration->madeAt, asked.today));
        if (const QString todo = standingNotice(standing); !todo.isEmpty())
            told += QStringLiteral(". ") + todo;
        return told;
    }

    /// The folder may be still to be made: it is where its nearest parent is.
    static QString disk(const QString& folder)
    {
        QFileInfo there{QFileInfo{folder}.absoluteFilePath()};
        while (!there.exists() && !there.isRoot())
            there.setFile(there.absolutePath());
        const QStorageInfo disk{there.absoluteFilePath()};
        if (!disk.isValid() || !there.isDir() || !there.isWritable())
            return tr("▲ %1 cannot be written into: choose another folder with --data").arg(folder);
        const QString free = QLocale{}.formattedDataSize(disk.bytesAvailable());
        return disk.bytesAvailable() < kLowDisk_bytes
                   ? tr("▲ %1 free in %2: make room before the session").arg(free, folder)
                   : tr("✓ %1 free in %2").arg(free, folder);
    }
};

} // namespace

QString timeServiceText(const std::optional<ExternalTime>& external)
{
    return external
               ? ReadyWords::tr("✓ set by a time service (NTP or PTP), to ±%1\u00a0ms")
                     .arg(1e3 * toSeconds(external->error), 0, 'f', 1)
               : ReadyWords::tr("○ not set by a time service that says how well (as chrony and "
                                "ntpd do, by NTP or PTP): other computers follow this one's "
                                "clock, to within half of the time that data take to them and "
                                "back");
}

std::vector<ReadyLine> readiness(const ReadinessQuestion& asked)
{
    std::vector<ReadyLine> lines;
    const auto say = [&lines](const QString& name, const QString& state) {
        lines.push_back({name, state});
    };
    const auto site =
        asked.site.isEmpty() ? std::nullopt : std::optional{readSiteFile(asked.site.toStdString())};
    if (!site) {
        say(ReadyWords::tr("Tracker"),
            ReadyWords::tr("○ no site: who has no tracker of their own watches"));
        say(ReadyWords::tr("Registration"), ReadyWords::tr("○ none is needed without a site"));
    } else if (!*site) {
        say(ReadyWords::tr("Site"), ReadyWords::tr("▲ %1").arg(errorText(site->error())));
    } else {
        say(ReadyWords::tr("Tracker"), ReadyWords::tracker(asked.site, **site));
        say(ReadyWords::tr("Registration"), ReadyWords::registration(**site, asked));
    }
    say(ReadyWords::tr("Disk"), ReadyWords::disk(asked.folder));
    say(ReadyWords::tr("Clock"), timeServiceText(readDisciplinedClock()));
    return lines;
}

} // namespace carina
