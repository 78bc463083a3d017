#include "apps/program/options/tracker_option.h"

#include "apps/program/options/openigtlink_option.h"
#include "tests/support/test_class.h"

#include <QTemporaryDir>

#include <fstream>

namespace carina::tracker_option_test
{
namespace
{

/// The tracker that these words name.
Result<std::optional<TrackerChoice>> named(const QStringList& words, std::string* record = nullptr,
                                           const QString& site = {})
{
    QCommandLineParser parser;
    program::addTrackerOption(parser, {});
    if (!parser.parse(QStringList{QStringLiteral("program")} + words))
        return fail(Errc::WrongOption, parser.errorText().toStdString());
    if (record != nullptr)
        *record = program::recordDeviceOption(parser);
    return program::trackerOption(parser, site);
}

void writeText(const QString& file, const char* text) { std::ofstream{file.toStdString()} << text; }

constexpr const char* kPolaris = R"({"schema": "carina.tracker/1", "kind": "ndi",
    "address": "192.0.2.7:8765", "tools": [{"name": "Chin", "role": "jaw"}]})";
constexpr const char* kServer = R"({"schema": "carina.tracker/1", "kind": "openigtlink",
    "address": "192.0.2.8:18944", "tools": [{"name": "Head", "role": "head"}]})";
constexpr const char* kSiteOfTwo = R"({"schema": "carina.site/3", "step": "tracker", "devices": [
    {"file": "polaris.json"},
    {"file": "server.json", "frame": {"X_TD_mm": [[1, 0, 0, 100], [0, 1, 0, 0], [0, 0, 1, 0],
     [0, 0, 0, 1]], "late_ms": -3, "rms_mm": 0.4, "rms_deg": 0.1, "pairs": 400,
     "calibrated_at": "2026-11-01T10:00:00Z"}}]})";

} // namespace

class TestTrackerOption : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// The longest name of an option and its value decides how much room all texts have.
    void givesItsExamplesInOneLine()
    {
        QCommandLineParser parser;
        program::addTrackerOption(parser, {});
        program::addOpenIgtLinkOption(parser);
        const QString help = parser.helpText();
        for (const char* example :
             {"(simulated:rate=30,hidden=tube)", "(simulated:intubation=good)"})
            QVERIFY2(help.contains(QString::fromLatin1(example)), qPrintable(help));
    }

    void recordsTheBytesOfADevice()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("tracker.json"));
        std::ofstream{file.toStdString()} << R"({"schema": "carina.tracker/1", "kind": "ndi",
            "address": "192.0.2.7:8765", "tools": [{"name": "a", "role": "tube"}]})";
        const auto choice = named({QStringLiteral("--tracker"), file,
                                   QStringLiteral("--record-device"), QStringLiteral("bytes.log")});
        QVERIFY2(choice, choice ? "" : choice.error().detail.c_str());
        QCOMPARE((*choice)->conversation, std::string{"bytes.log"});
    }

    /// For a tracker that is chosen in a window later.
    void recordsTheBytesWithoutATrackerToo()
    {
        std::string record;
        const auto choice =
            named({QStringLiteral("--record-device"), QStringLiteral("bytes.log")}, &record);
        QVERIFY(choice && !*choice);
        QCOMPARE(record, std::string{"bytes.log"});
    }

    void takesTheDevicesOfTheSiteWhereNoneIsNamed()
    {
        const QTemporaryDir folder;
        const QString site = folder.filePath(QStringLiteral("site.json"));
        writeText(folder.filePath(QStringLiteral("polaris.json")), kPolaris);
        writeText(folder.filePath(QStringLiteral("server.json")), kServer);
        writeText(site, kSiteOfTwo);
        const auto choice = named({}, nullptr, site);
        QVERIFY2(choice, choice ? "" : choice.error().detail.c_str());
        QVERIFY(choice->has_value());
        QCOMPARE(trackerName(**choice),
                 QStringLiteral("NDI tracker at 192.0.2.7:8765 + OpenIGTLink server at "
                                "192.0.2.8:18944"));
        QCOMPARE(trackerIdentity(**choice), QStringLiteral("NDI tracker at 192.0.2.7:8765"));
        const auto tracker = makeTracker(**choice, [] { return std::optional<SessionTime>{}; });
        QVERIFY2(tracker, tracker ? "" : tracker.error().detail.c_str());
        const auto tools = (*tracker)->tools();
        QCOMPARE(tools.size(), 2U);
        QVERIFY(!tools[0].history->deviceFrame());
        QCOMPARE(tools[1].history->deviceFrame()->translation().x(), 0.1);

        const auto other =
            named({QStringLiteral("--tracker"), QStringLiteral("simulated")}, nullptr, site);
        QVERIFY(other && *other && (*other)->isSimulated());
        const auto same =
            named({QStringLiteral("--tracker"), QStringLiteral("site")}, nullptr, site);
        QVERIFY(same && areSameDevices(*same, *choice));
        const auto nowhere = named({QStringLiteral("--tracker"), QStringLiteral("site")});
        QVERIFY(!nowhere);
        QCOMPARE(nowhere.error().code, Errc::WrongOption);
    }

    void takesNoneWhereTheSiteNamesNone()
    {
        const QTemporaryDir folder;
        const QString site = folder.filePath(QStringLiteral("site.json"));
        const auto missing = named({}, nullptr, site);
        QVERIFY(missing && !*missing);
        writeText(site, R"({"schema": "carina.site/3", "step": "tracker"})");
        const auto none = named({}, nullptr, site);
        QVERIFY(none && !*none);
    }

    void takesOptionsOfTheSimulatedTracker()
    {
        const auto choice =
            named({QStringLiteral("--tracker"), QStringLiteral("simulated:rate=30,partly=head")});
        QVERIFY2(choice, choice ? "" : choice.error().detail.c_str());
        QVERIFY((*choice)->isSimulated());
        const auto& settings = std::get<SimulatedDevice>((*choice)->device).settings;
        QCOMPARE(settings.rate, hertz(30.0));
        QCOMPARE(settings.occlusions.size(), 1U);
        const auto wrong =
            named({QStringLiteral("--tracker"), QStringLiteral("simulated:speed=2")});
        QVERIFY(!wrong);
        QCOMPARE(wrong.error().code, Errc::WrongOption);
        QVERIFY(wrong.error().detail.find("dropouts=PERCENT") != std::string::npos);
    }

    void refusesToRecordWhereThereAreNoBytes()
    {
        const auto choice = named({QStringLiteral("--tracker"), QStringLiteral("simulated"),
                                   QStringLiteral("--record-device"), QStringLiteral("bytes.log")});
        QVERIFY(!choice);
        QCOMPARE(choice.error().code, Errc::WrongOption);
        QVERIFY(choice.error().detail.starts_with("--record-device: "));
    }
};

CARINA_TEST(TestTrackerOption)

} // namespace carina::tracker_option_test

#include "tst_tracker_option.moc"
