#include "models/tracker/tracker_form.h"

#include "engine/io/site/devices/camera_file.h"
#include "tests/support/test_class.h"

#include <QTemporaryDir>

#include <fstream>
#include <set>

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
        row("no webcam", {.source = TrackerSource::Webcam}, "webcam");
        row("a webcam", {.source = TrackerSource::Webcam, .webcam = QStringLiteral("0")}, "");
    }

    void saysWhatIsMissing()
    {
        QFETCH(const TrackerForm, form);
        QFETCH(const QString, said);
        const auto missing = whatIsMissing(form);
        QCOMPARE(missing.has_value(), !said.isEmpty());
        QVERIFY2(missing.value_or(said).contains(said), qPrintable(missing.value_or(said)));
    }

    void calibratesWhatMayBeACamera()
    {
        TrackerForm form{.source = TrackerSource::Description};
        QVERIFY(!canCalibrateCamera(form));
        form.description = QStringLiteral("/site/tracker.json");
        QVERIFY(canCalibrateCamera(form));
        form.description = QStringLiteral("/site/PlusDeviceSet.XML ");
        QVERIFY(!canCalibrateCamera(form));
        form.source = TrackerSource::Webcam;
        QVERIFY(!canCalibrateCamera(form));
        form.webcam = QStringLiteral("0");
        QVERIFY(canCalibrateCamera(form));
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

    /// One reader for the window and the option of a start.
    void simulatesWhatTheOptionWould()
    {
        const SimulatedOptions options{.rate_Hz = 30.0,
                                       .dropouts_percent = 5.0,
                                       .hidden = {ToolRole::Tube},
                                       .partly = {ToolRole::Head}};
        QCOMPARE(simulatedName(options),
                 QStringLiteral("simulated:rate=30,hidden=tube,partly=head,dropouts=5"));
        QCOMPARE(simulatedName({}), QStringLiteral("simulated"));
        const auto choice = choiceOf({.simulated = options});
        QVERIFY2(choice, choice ? "" : choice.error().detail.c_str());
        const auto& settings = std::get<SimulatedDevice>(choice->device).settings;
        QCOMPARE(settings.rate, hertz(30.0));
        QCOMPARE(settings.dropouts, 0.05);
        QCOMPARE(settings.occlusions.size(), std::size_t{2});
        QCOMPARE(settings.occlusions[0].tool, ToolRole::Tube);
        QCOMPARE(settings.occlusions[0].share, 1.0);
        QCOMPARE(settings.occlusions[1].tool, ToolRole::Head);
        QVERIFY(settings.occlusions[1].share < 1.0);
        const auto wrong = choiceOf({.simulated = {.rate_Hz = 5000.0}});
        QVERIFY(!wrong);
        QCOMPARE(wrong.error().code, Errc::WrongOption);
    }

    void tracksThePrintedToolsWithAWebcamThatNoFileDescribes()
    {
        const auto choice =
            choiceOf({.source = TrackerSource::Webcam, .webcam = QStringLiteral(" 2 ")});
        QVERIFY2(choice, choice ? "" : choice.error().detail.c_str());
        const auto& described = std::get<TrackerDescription>(choice->device);
        QCOMPARE(described.kind, TrackerKind::Camera);
        QCOMPARE(described.address, std::string{"/dev/video2"});
        QVERIFY(isUsable(described.camera));
        QVERIFY(described.calibration.empty());
        std::set<ToolRole> roles;
        std::set<int> markers;
        for (const DescribedTool& tool : described.tools) {
            QVERIFY(tool.body.has_value() && roles.insert(tool.role).second);
            for (const BodyMarker& marker : tool.body->markers)
                QVERIFY(markers.insert(marker.id).second);
        }
        QVERIFY(roles.contains(ToolRole::Stylus) && roles.contains(ToolRole::Tube));
    }

    void takesTheCalibrationOfAWebcam()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("camera.json"));
        const CameraModel mine{
            .width = 640, .height = 480, .focal = {700.0, 701.0}, .centre = {320.0, 240.0}};
        QVERIFY(writeCameraFile(file.toStdString(), {.model = mine}));
        TrackerForm form{.source = TrackerSource::Webcam,
                         .webcam = QStringLiteral("/tmp/tools.mp4"),
                         .calibration = file};
        const auto choice = choiceOf(form);
        QVERIFY2(choice, choice ? "" : choice.error().detail.c_str());
        const auto& described = std::get<TrackerDescription>(choice->device);
        QCOMPARE(described.address, std::string{"/tmp/tools.mp4"});
        QCOMPARE(described.camera.width, 640);
        QCOMPARE(described.camera.focal.y(), 701.0);
        QCOMPARE(described.calibration, file.toStdString());
        form.calibration = folder.filePath(QStringLiteral("none.json"));
        QCOMPARE(choiceOf(form).error().code, Errc::FileNotFound);
    }

    void recordsTheBytesOfADeviceOnly()
    {
        TrackerForm form = polaris();
        form.conversation = QStringLiteral(" bytes.log ");
        QCOMPARE(choiceOf(form)->conversation, std::string{"bytes.log"});
        form.source = TrackerSource::Simulated;
        QCOMPARE(choiceOf(form)->conversation, std::string{});
        form.source = TrackerSource::Webcam;
        form.webcam = QStringLiteral("0");
        QCOMPARE(choiceOf(form)->conversation, std::string{});
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
