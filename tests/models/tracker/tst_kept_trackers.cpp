#include "models/tracker/kept_trackers.h"

#include "tests/support/test_class.h"

#include <QFile>
#include <QTemporaryDir>

#include <fstream>

namespace carina::kept_trackers_test
{
namespace
{

constexpr const char* kByHand = R"({"schema": "carina.tracker/1", "kind": "ndi",
    "address": "192.0.2.7:8765", "poses": "BX2", "fastest_rate": 57600,
    "tools": [{"name": "The long pointer", "role": "stylus"}]})";

/// A folder of a site.
class SiteFolder
{
public:
    [[nodiscard]] std::filesystem::path path(const char* name) const
    {
        return std::filesystem::path{m_folder.path().toStdString()} / name;
    }
    void write(const char* name, const std::string& text) const
    {
        std::ofstream{path(name)} << text;
    }
    [[nodiscard]] QByteArray bytes(const char* name) const
    {
        QFile file{QString::fromStdString(path(name).string())};
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray{};
    }
    [[nodiscard]] std::string keep(const TrackerDescription& description) const
    {
        const auto file = keepTracker(path("tracker.json"), description);
        return file ? file->filename().string() : file.error().detail;
    }

private:
    QTemporaryDir m_folder;
};

TrackerDescription polarisAt(const std::string& address)
{
    const std::vector<ToolMarker> markers{{{0, 0, 0}}, {{0.05, 0, 0}}, {{0, 0.08, 0}}};
    TrackerDescription described{.address = address};
    described.tools.push_back(
        {"Tube", ToolRole::Tube,
         NdiToolDefinition::make(NdiToolDefinition::Kind::Pointer, markers, "Carina", "tube")
             .value()});
    return described;
}

} // namespace

class TestKeptTrackers : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void writesToNothingThatIsThere()
    {
        const SiteFolder folder;
        folder.write("tracker.json", kByHand);
        folder.write("tracker_2-1.rom", "a definition of somebody");
        QCOMPARE(folder.keep(polarisAt("host:1")), std::string{"tracker_3.json"});
        QCOMPARE(folder.bytes("tracker.json"), QByteArray{kByHand});
        QCOMPARE(folder.bytes("tracker_2-1.rom"), QByteArray{"a definition of somebody"});
        const auto kept = readTrackerFile(folder.path("tracker_3.json"));
        QVERIFY2(kept, kept ? "" : kept.error().detail.c_str());
        QCOMPARE(kept->tools[0].definition->partNumber(), std::string{"tube"});
    }

    void writesTheSameTrackerOnce()
    {
        const SiteFolder folder;
        QCOMPARE(folder.keep(polarisAt("host:1")), std::string{"tracker.json"});
        QCOMPARE(folder.keep(polarisAt("host:1")), std::string{"tracker.json"});
        QCOMPARE(folder.keep(polarisAt("host:2")), std::string{"tracker_2.json"});
        auto slow = polarisAt("host:1");
        slow.fastestRate = 9600;
        QCOMPARE(folder.keep(slow), std::string{"tracker_3.json"});
        QCOMPARE(folder.keep(polarisAt("host:2")), std::string{"tracker_2.json"});
    }

    void offersTheLastOneFirst()
    {
        const SiteFolder folder;
        const auto kept = folder.path("tracker.json");
        QVERIFY(!lastKeptTracker(kept));
        QVERIFY(formOfKept(kept) == TrackerForm{});
        folder.write("tracker.json", kByHand);
        std::filesystem::last_write_time(kept, std::filesystem::file_time_type::clock::now()
                                                   - std::chrono::hours{1});
        QVERIFY(lastKeptTracker(kept) == kept);
        QCOMPARE(folder.keep(polarisAt("host:1")), std::string{"tracker_2.json"});
        QVERIFY(lastKeptTracker(kept) == folder.path("tracker_2.json"));
        QCOMPARE(formOfKept(kept).address, QStringLiteral("host:1"));
    }

    void beginsWithWhatWasWrittenByHand()
    {
        const SiteFolder folder;
        folder.write("tracker.json", kByHand);
        const TrackerForm form = formOfKept(folder.path("tracker.json"));
        QCOMPARE(form.source, TrackerSource::Description);
        QCOMPARE(form.address, QStringLiteral("192.0.2.7:8765"));
        QCOMPARE(form.poses, NdiPoseReply::Bx2);
        QCOMPARE(form.fastestRate, 57600);
    }

    /// The registration of a site rests on the description as it is read.
    void keepsAWebcamOnce()
    {
        const SiteFolder folder;
        TrackerForm form{.source = TrackerSource::Webcam, .webcam = QStringLiteral("1")};
        QVERIFY(isToBeKept(form));
        const auto webcam = std::get<TrackerDescription>(choiceOf(form).value().device);
        folder.write("tracker-camera.json", "of somebody");
        QCOMPARE(folder.keep(webcam), std::string{"tracker_2.json"});
        QCOMPARE(folder.keep(webcam), std::string{"tracker_2.json"}); // though it was rounded
        QCOMPARE(folder.bytes("tracker-camera.json"), QByteArray{"of somebody"});
        auto calibrated = webcam;
        calibrated.camera.focal.x() += 1.0;
        QCOMPARE(folder.keep(calibrated), std::string{"tracker_3.json"});
        auto moved = webcam;
        moved.tools[0].body->markers[0].side += 1e-4;
        QCOMPARE(folder.keep(moved), std::string{"tracker_4.json"});
        const auto kept = readTrackerFile(folder.path("tracker_2.json"));
        QVERIFY2(kept, kept ? "" : kept.error().detail.c_str());
        QCOMPARE(kept->tools.size(), webcam.tools.size());
        QCOMPARE(formOfKept(folder.path("tracker.json")).webcam, QStringLiteral("/dev/video1"));
        form.webcam = QStringLiteral("/media/tools.mp4"); // a description cannot name it
        QVERIFY(!isToBeKept(form));
    }

    void beginsWithTheToolsOfAServer()
    {
        const SiteFolder folder;
        TrackerDescription server{.address = "host:18944", .kind = TrackerKind::OpenIgtLink};
        server.tools.push_back({.name = "Tube", .role = ToolRole::Tube, .device = "TubeToTracker"});
        QCOMPARE(folder.keep(server), std::string{"tracker.json"});
        const TrackerForm form = formOfKept(folder.path("tracker.json"));
        QCOMPARE(form.server, QStringLiteral("host:18944"));
        QCOMPARE(form.served,
                 (std::vector<ServedTool>{{QStringLiteral("TubeToTracker"), ToolRole::Tube}}));
    }
};

CARINA_TEST(TestKeptTrackers)

} // namespace carina::kept_trackers_test

#include "tst_kept_trackers.moc"
