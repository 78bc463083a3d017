#include "models/session/readiness.h"

#include "engine/io/site/site_file.h"
#include "models/tracker/tracker_choice.h"
#include "tests/models/registration/made_site.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_class.h"

namespace carina::readiness_test
{
namespace
{

using namespace test;

const QDateTime kThreeDaysLater{{2004, 3, 30}, {12, 0}, Qt::UTC};

QString stateOf(const std::vector<ReadyLine>& lines, const char* name)
{
    for (const ReadyLine& line : lines)
        if (line.name == QLatin1String{name})
            return line.state;
    return {};
}

} // namespace

class TestReadiness : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void needsNeitherTrackerNorRegistrationWithoutASite()
    {
        const ScratchFolder folder;
        const auto lines = readiness({.folder = folder.path(), .today = kThreeDaysLater});
        QVERIFY(stateOf(lines, "Tracker").startsWith(QStringLiteral("○")));
        QVERIFY(stateOf(lines, "Registration").startsWith(QStringLiteral("○")));
        QVERIFY(stateOf(lines, "Disk").contains(folder.path()));
        QVERIFY(!stateOf(lines, "Clock").isEmpty());
    }

    void saysInPlainWordsWhoSetsTheClock()
    {
        QVERIFY(timeServiceText({}).startsWith(QStringLiteral("○ not set by a time service")));
        QCOMPARE(timeServiceText(ExternalTime{{}, std::chrono::microseconds{2500}}),
                 QStringLiteral("✓ set by a time service (NTP or PTP), to ±2.5\u00a0ms"));
    }

    void tellsErrorAndAgeOfTheRegistration()
    {
        const ScratchFolder folder;
        const QString site = folder.filePath("site.json");
        Site verified = verifiedSite();
        verified.registration->madeAt = "2004-03-27T10:40:00Z";
        verified.verification->at = "2004-03-27T10:50:00Z";
        QVERIFY(writeSiteFile(site.toStdString(), verified));
        const auto lines =
            readiness({.site = site, .folder = folder.path(), .today = kThreeDaysLater});
        const QString told = stateOf(lines, "Registration");
        QVERIFY2(told.startsWith(QStringLiteral("✓")), qPrintable(told));
        QVERIFY2(told.contains(QStringLiteral("3 days ago")), qPrintable(told));
    }

    /// Which may be switched off, or at another place.
    void ticksNoTrackerThatNobodyAsked()
    {
        const ScratchFolder folder;
        const QString site = folder.filePath("site.json");
        QVERIFY(writeSiteFile(site.toStdString(), verifiedSite()));
        const auto state = [&] {
            return stateOf(
                readiness({.site = site, .folder = folder.path(), .today = kThreeDaysLater}),
                "Tracker");
        };
        QVERIFY2(state().startsWith(QStringLiteral("○")), qPrintable(state()));
        QVERIFY2(state().contains(QString::fromStdString(kTracker)), qPrintable(state()));
        QVERIFY2(state().contains(QStringLiteral("not asked yet")), qPrintable(state()));
        static_cast<void>(
            folder.write("tracker.json", R"({"schema": "carina.tracker/1", "kind": "openigtlink",
            "address": "192.0.2.7:18944", "tools": [{"name": "Head", "role": "head"}]})"));
        QVERIFY2(state().startsWith(QStringLiteral("○")), qPrintable(state()));
        QVERIFY2(state().contains(QStringLiteral("192.0.2.7:18944")), qPrintable(state()));
        QVERIFY2(state().contains(QStringLiteral("not asked yet")), qPrintable(state()));
    }

    void ticksTheSimulatedTracker()
    {
        const ScratchFolder folder;
        const QString site = folder.filePath("site.json");
        const QString name = trackerIdentity(TrackerChoice{SimulatedDevice{}});
        Site registered = verifiedSite();
        registered.tracker = name.toStdString();
        QVERIFY(writeSiteFile(site.toStdString(), registered));
        const QString told =
            stateOf(readiness({.site = site, .folder = folder.path(), .today = kThreeDaysLater}),
                    "Tracker");
        QVERIFY2(told.startsWith(QStringLiteral("✓")), qPrintable(told));
        QVERIFY2(told.contains(name), qPrintable(told));
    }

    void namesTheDevicesOfTheSite()
    {
        const ScratchFolder folder;
        const QString site = folder.filePath("site.json");
        Site named = verifiedSite();
        named.devices = {{.file = "server.json"}};
        QVERIFY(writeSiteFile(site.toStdString(), named));
        const auto state = [&] {
            return stateOf(
                readiness({.site = site, .folder = folder.path(), .today = kThreeDaysLater}),
                "Tracker");
        };
        QVERIFY2(state().startsWith(QStringLiteral("▲")), qPrintable(state())); // it is not there
        static_cast<void>(
            folder.write("server.json", R"({"schema": "carina.tracker/1", "kind": "openigtlink",
            "address": "192.0.2.8:18944", "tools": [{"name": "Head", "role": "head"}]})"));
        QVERIFY2(state().startsWith(QStringLiteral("○")), qPrintable(state()));
        QVERIFY(state().contains(QStringLiteral("192.0.2.8:18944")));
        QVERIFY2(state().contains(QStringLiteral("not asked yet")), qPrintable(state()));
    }

    void saysWhatToDoAboutASiteThatIsNot()
    {
        const ScratchFolder folder;
        const QString site = folder.write("site.json", "{");
        const auto lines =
            readiness({.site = site, .folder = folder.path(), .today = kThreeDaysLater});
        QVERIFY(stateOf(lines, "Site").startsWith(QStringLiteral("▲")));
    }

    /// As for a person who never started the console before.
    void tellsTheDiskOfAFolderThatIsStillToBeMade()
    {
        const ScratchFolder folder;
        const auto lines =
            readiness({.folder = folder.filePath("new/folder"), .today = kThreeDaysLater});
        QVERIFY2(!stateOf(lines, "Disk").contains(QStringLiteral("cannot be written")),
                 qPrintable(stateOf(lines, "Disk")));
    }

    void refusesAFolderThatCannotBeMade()
    {
        const ScratchFolder folder;
        const QString file = folder.write("file", "");
        const auto lines =
            readiness({.folder = file + QStringLiteral("/folder"), .today = kThreeDaysLater});
        QVERIFY(stateOf(lines, "Disk").startsWith(QStringLiteral("▲")));
    }
};

CARINA_TEST(TestReadiness)

} // namespace carina::readiness_test

#include "tst_readiness.moc"
