#include "apps/program/tracker_option.h"

#include "tests/support/test_class.h"

#include <QTemporaryDir>

#include <fstream>

namespace carina::tracker_option_test
{
namespace
{

/// The tracker that these words name.
Result<std::optional<TrackerChoice>> named(const QStringList& words, std::string* record = nullptr)
{
    QCommandLineParser parser;
    program::addTrackerOption(parser, {});
    if (!parser.parse(QStringList{QStringLiteral("program")} + words))
        return fail(Errc::WrongOption, parser.errorText().toStdString());
    if (record != nullptr)
        *record = program::recordDeviceOption(parser);
    return program::trackerOption(parser);
}

} // namespace

class TestTrackerOption : public QObject
{
    Q_OBJECT

private Q_SLOTS:
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
