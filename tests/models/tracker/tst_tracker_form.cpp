#include "models/tracker/tracker_form.h"

#include "tests/support/test_class.h"

#include <QTemporaryDir>

#include <fstream>

namespace carina::tracker_form_test
{
namespace
{

TrackerForm polaris()
{
    return {.source = TrackerSource::Polaris, .address = QStringLiteral("192.0.2.7:8765")};
}

/// Two frames of a stylus.
void writeRecording(const QString& file)
{
    std::ofstream out{file.toStdString()};
    out << "ObjectType = Image\nNDims = 3\nDimSize = 0 0 2\n";
    for (const char* frame : {"Seq_Frame0000", "Seq_Frame0001"})
        out << frame << "_StylusToTrackerTransform = 1 0 0 100 0 1 0 0 0 0 1 -50 0 0 0 1\n"
            << frame << "_StylusToTrackerTransformStatus = OK\n"
            << frame << "_Timestamp = " << frame[12] << '\n';
    out << "ElementDataFile = LOCAL\n";
}

} // namespace

class TrackerFormTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void saysWhatIsMissing_data()
    {
        QTest::addColumn<TrackerForm>("form");
        QTest::addColumn<QString>("said");
        const auto row = [](const char* name, TrackerForm form, const char* said) {
            QTest::newRow(name) << form << QString::fromLatin1(said);
        };
        row("the simulated tracker", {}, "");
        row("a whole Polaris", polaris(), "");
        TrackerForm form = polaris();
        form.address = QStringLiteral("ttyUSB0");
        row("no address", form, "192.0.2.7:8765");
        form.address = QStringLiteral(" /dev/ttyUSB0 ");
        row("a serial port", form, "");
        form.tools.clear();
        row("no tools", form, "stylus");
        form.tools = {{ToolRole::Jaw, {}}, {ToolRole::Jaw, {}}};
        row("a role twice", form, "Chin probe");
        form.tools = {{ToolRole::Other, {}}, {ToolRole::Other, {}}};
        row("two of no role", form, "");
        row("no recording", {.source = TrackerSource::Recording}, ".igs.mha");
        row("no description", {.source = TrackerSource::Description}, ".json");
    }

    void saysWhatIsMissing()
    {
        QFETCH(const TrackerForm, form);
        QFETCH(const QString, said);
        const auto missing = whatIsMissing(form);
        QCOMPARE(missing.has_value(), !said.isEmpty());
        QVERIFY2(missing.value_or(said).contains(said), qPrintable(missing.value_or(said)));
    }

    void describesAPolarisAsItWasFilledIn()
    {
        const QTemporaryDir folder;
        const std::vector<ToolMarker> markers{{{0, 0, 0}}, {{0.05, 0, 0}}, {{0, 0.08, 0}}};
        const auto tube =
            NdiToolDefinition::make(NdiToolDefinition::Kind::Pointer, markers, "Carina", "tube");
        const QString file = folder.filePath(QStringLiteral("tube.rom"));
        std::ofstream{file.toStdString(), std::ios::binary}.write(
            reinterpret_cast<const char*>(tube->bytes().data()), NdiToolDefinition::kBytes);
        TrackerForm form = polaris();
        form.tools = {{ToolRole::Stylus, {}}, {ToolRole::Tube, file}, {ToolRole::Other, {}}};
        form.poses = NdiPoseReply::Bx2;
        form.fastestRate = 57600;
        const auto choice = choiceOf(form);
        QVERIFY(choice);
        const auto& described = std::get<TrackerDescription>(choice->device);
        QCOMPARE(described.address, std::string{"192.0.2.7:8765"});
        QCOMPARE(described.poses, NdiPoseReply::Bx2);
        QCOMPARE(described.fastestRate, 57600);
        QCOMPARE(described.tools.size(), std::size_t{3});
        QCOMPARE(described.tools[0].name, std::string{"Stylus"});
        QVERIFY(!described.tools[0].definition);
        QCOMPARE(described.tools[1].definition->partNumber(), std::string{"tube"});
        QCOMPARE(described.tools[2].name, std::string{"Tool 3"});
        QCOMPARE(trackerName(*choice), QStringLiteral("NDI tracker at 192.0.2.7:8765"));
        QVERIFY(trackerIdentity(*choice).startsWith(trackerName(*choice) + QStringLiteral(" (")));
    }

    /// What was registered before is no longer right.
    void anotherCalibrationOrMarkerMakesAnotherTracker()
    {
        const std::vector<ToolMarker> markers{{{0, 0, 0}}, {{0.05, 0, 0}}, {{0, 0.08, 0}}};
        const auto stylus =
            NdiToolDefinition::make(NdiToolDefinition::Kind::Pointer, markers, "Carina", "s");
        TrackerDescription polaris{.address = "/dev/ttyUSB0"};
        polaris.tools = {{"Stylus", ToolRole::Stylus, stylus.value()}};
        const QString before = trackerIdentity({polaris});
        polaris.tools.push_back({"Hand", ToolRole::Hand, stylus.value()});
        QCOMPARE(trackerIdentity({polaris}), before); // nothing is registered with it
        polaris.tools[0].definition = stylus->withMarker(1, {0.051, 0, 0}).value();
        QVERIFY(trackerIdentity({polaris}) != before);

        TrackerDescription webcam{.address = "/dev/video0", .kind = TrackerKind::Camera};
        webcam.camera.focal = {800.0, 800.0};
        webcam.tools = {{"Chin", ToolRole::Jaw}};
        webcam.tools[0].body = MarkedBody{.markers = {{.id = 1, .side = 0.03, .X_BK = {}}}};
        const QString calibrated = trackerIdentity({webcam});
        webcam.camera.focal.x() = 801.0;
        QVERIFY(trackerIdentity({webcam}) != calibrated);
        webcam.camera.focal.x() = 800.0;
        QCOMPARE(trackerIdentity({webcam}), calibrated);
        webcam.tools[0].body->markers[0].side = 0.031;
        QVERIFY(trackerIdentity({webcam}) != calibrated);
    }

    void namesADefinitionThatIsMissing()
    {
        TrackerForm form = polaris();
        form.tools = {{ToolRole::Stylus, QStringLiteral("/nowhere/stylus.rom")}};
        const auto choice = choiceOf(form);
        QVERIFY(!choice);
        QCOMPARE(choice.error().code, Errc::FileNotFound);
    }

    void playsARecordingThatMayBeOfAnyTracker()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("swing.igs.mha"));
        writeRecording(file);
        for (const auto& choice :
             {trackerNamed(QStringLiteral("recorded:") + file),
              trackerNamed(QStringLiteral("looped:") + file),
              choiceOf({.source = TrackerSource::Recording, .recording = file})}) {
            QVERIFY2(choice, choice ? "" : choice.error().detail.c_str());
            QCOMPARE(trackerName(*choice), QStringLiteral("Recording of swing.igs.mha"));
            QCOMPARE(trackerIdentity(*choice), QString{});
            const auto tracker = makeTracker(*choice, [] { return std::optional<SessionTime>{}; });
            QVERIFY(tracker);
            QCOMPARE((*tracker)->tools().at(0).role, ToolRole::Stylus);
        }
    }

    void playsARecordingOnceOrAgainAndAgain()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("swing.igs.mha"));
        writeRecording(file);
        const auto playing = [](const Result<TrackerChoice>& choice) {
            return std::get<PlayedRecording>(choice.value().device).playing;
        };
        QCOMPARE(playing(trackerNamed(QStringLiteral("recorded:") + file)), Playing::Once);
        QCOMPARE(playing(trackerNamed(QStringLiteral("looped:") + file)), Playing::Looped);
        TrackerForm form{.source = TrackerSource::Recording, .recording = file};
        QCOMPARE(playing(choiceOf(form)), Playing::Once);
        form.isLooped = true;
        QCOMPARE(playing(choiceOf(form)), Playing::Looped);
    }

    void takesTheWordsOfTheOption()
    {
        QVERIFY(trackerNamed(QStringLiteral("simulated"))->isSimulated());
        for (const char* words : {"nowhere.json", "recorded:nowhere.igs.mha", "Simulated"}) {
            const auto choice = trackerNamed(QLatin1String{words});
            QVERIFY(!choice);
            QCOMPARE(choice.error().code, Errc::FileNotFound);
        }
    }
};

CARINA_TEST(TrackerFormTest)

} // namespace carina::tracker_form_test

#include "tst_tracker_form.moc"
