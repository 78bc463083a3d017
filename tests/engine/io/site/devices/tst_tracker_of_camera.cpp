#include "engine/io/site/devices/camera_file.h"
#include "engine/io/site/devices/tracker_file.h"

#include "tests/support/test_class.h"

#include <QDir>
#include <QTemporaryDir>

#include <fstream>

namespace carina::tracker_of_camera_test
{
namespace
{

/// A folder with the description of a camera and the files that it names.
class CameraFolder
{
public:
    CameraFolder()
    {
        write("markers.avi", "a video");
        write("camera.yml", "image_width: 640\nimage_height: 480\ncamera_matrix: x\n data: [ 500, "
                            "0, 320, 0, 500, 240, 0, 0, 1 ]\ndistortion_coefficients: x\n data: [ "
                            "0, 0, 0, 0, 0 ]\n");
        write("tube.json", markers("4x4_50", 6));
        write("chin.json", markers("4x4_50", 7));
        write("large.json", markers("5x5_50", 7));
    }

    /// The description, with one of its words replaced.
    [[nodiscard]] Result<TrackerDescription> read(const std::string& before = "markers.avi",
                                                  const std::string& after = "markers.avi") const
    {
        std::string text = R"({"schema": "carina.tracker/1", "kind": "camera",
            "address": "markers.avi", "calibration": "camera.yml", "looped": true, "tools": [
            {"name": "Tube", "role": "tube", "definition": "tube.json"},
            {"name": "Chin", "role": "jaw", "definition": "chin.json"}]})";
        text.replace(text.find(before), before.size(), after);
        write("tracker.json", text);
        return readTrackerFile(pathOf("tracker.json"));
    }

    [[nodiscard]] std::string pathOf(const char* name) const
    {
        return QDir{QDir{m_folder.path()}.canonicalPath()}
            .filePath(QString::fromLatin1(name))
            .toStdString();
    }

private:
    static std::string markers(const char* dictionary, int id)
    {
        std::string text = R"({"schema": "carina.markers/1", "dictionary": "DICTIONARY",
            "markers": [{"id": ID, "side_mm": 30, "X_BK_mm":
            [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]}]})";
        text.replace(text.find("DICTIONARY"), 10, dictionary);
        return text.replace(text.find("ID"), 2, std::to_string(id));
    }

    void write(const char* name, const std::string& bytes) const
    {
        std::ofstream{pathOf(name), std::ios::binary} << bytes;
    }

    QTemporaryDir m_folder;
};

} // namespace

/// The description of a tracker that is a camera.
class TestTrackerOfCamera : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void readsACameraAndWhatItNames()
    {
        const CameraFolder folder;
        const auto tracker = folder.read();
        QVERIFY2(tracker, tracker ? "" : tracker.error().detail.c_str());
        QVERIFY(tracker->kind == TrackerKind::Camera);
        QCOMPARE(tracker->address, folder.pathOf("markers.avi"));
        QVERIFY(tracker->isLooped);
        QCOMPARE(tracker->rate_hz, 30);
        QCOMPARE(tracker->camera.width, 640);
        QCOMPARE(tracker->tools.size(), std::size_t{2});
        QCOMPARE(tracker->tools[1].body->markers[0].id, 7);
        // And written and read again.
        const auto file = folder.pathOf("again.json");
        QVERIFY(writeTrackerFile(file, *tracker));
        const auto again = readTrackerFile(file);
        QVERIFY2(again, again ? "" : again.error().detail.c_str());
        QCOMPARE(again->address, tracker->address);
        QVERIFY(again->isLooped);
        QCOMPARE(again->camera.focal, tracker->camera.focal);
        QCOMPARE(again->tools[0].role, ToolRole::Tube);
        QCOMPARE(again->tools[0].body->markers[0].side, 0.03);
    }

    void keepsTheCalibrationThatItIsFrom()
    {
        const CameraFolder folder;
        const auto file = folder.pathOf("again.json");
        const auto calibration = folder.pathOf("again-camera.json");
        auto tracker = folder.read();
        QVERIFY(tracker);
        QVERIFY(writeCameraFile(
            calibration, {.model = tracker->camera, .rms = 0.3, .pictures = 12, .madeAt = "noon"}));
        tracker->calibration = calibration;
        QVERIFY(writeTrackerFile(file, *tracker));
        QCOMPARE(readCameraFile(calibration)->pictures, 12);
        QCOMPARE(readCameraFile(calibration)->madeAt, std::string{"noon"});
    }

    void namesAnotherCalibrationAndKeepsTheRest()
    {
        const CameraFolder folder;
        auto tracker = folder.read();
        QVERIFY(tracker);
        const auto file = folder.pathOf("tracker.json");
        tracker->camera.focal *= 2.0;
        QVERIFY(writeCameraFile(folder.pathOf("own.json"), {.model = tracker->camera}));
        QVERIFY(nameCalibration(file, folder.pathOf("own.json")));
        const auto again = readTrackerFile(file);
        QVERIFY2(again, again ? "" : again.error().detail.c_str());
        QCOMPARE(again->camera.focal, tracker->camera.focal);
        QCOMPARE(again->address, tracker->address);
        QVERIFY(again->isLooped);
        QCOMPARE(again->tools.size(), std::size_t{2});
    }

    void takesAWebcamAsItIsNamed()
    {
        const auto tracker = CameraFolder{}.read("markers.avi", "/dev/video7");
        QVERIFY2(tracker, tracker ? "" : tracker.error().detail.c_str());
        QCOMPARE(tracker->address, std::string{"/dev/video7"});
    }

    void namesWhatIsWrongWithACamera_data()
    {
        QTest::addColumn<QString>("before");
        QTest::addColumn<QString>("after");
        QTest::addColumn<Errc>("code");
        QTest::addColumn<QByteArray>("named");
        const auto row = [](const char* tag, const char* before, const char* after, Errc code,
                            const char* named) {
            QTest::newRow(tag) << QString::fromLatin1(before) << QString::fromLatin1(after) << code
                               << QByteArray{named};
        };
        row("no video", "markers.avi", "other.avi", Errc::FileNotFound, "other.avi");
        row("a video elsewhere", "markers.avi", "../markers.avi", Errc::FileNotFound,
            "markers.avi");
        row("no calibration", "\"calibration\"", "\"lens\"", Errc::FileMalformed, "lens");
        row("a calibration that is not there", "camera.yml", "lens.yml", Errc::FileNotFound,
            "lens.yml");
        row("a tool without markers", ", \"definition\": \"tube.json\"", "", Errc::FileMalformed,
            "definition");
        row("markers on two tools", "chin.json", "tube.json", Errc::FileMalformed, "marker 6");
        row("markers of two dictionaries", "chin.json", "large.json", Errc::FileMalformed,
            "dictionary");
        row("a rate of 0", "\"looped\"", "\"rate\": 0, \"looped\"", Errc::FileMalformed, "rate");
        row("a device", "\"definition\": \"chin.json\"", "\"device\": \"chin\"",
            Errc::FileMalformed, "device");
    }

    void namesWhatIsWrongWithACamera()
    {
        QFETCH(const QString, before);
        QFETCH(const QString, after);
        QFETCH(const Errc, code);
        QFETCH(const QByteArray, named);
        const auto tracker = CameraFolder{}.read(before.toStdString(), after.toStdString());
        QVERIFY(!tracker);
        QCOMPARE(tracker.error().code, code);
        QVERIFY2(QByteArray::fromStdString(tracker.error().detail).contains(named),
                 tracker.error().detail.c_str());
    }
};

CARINA_TEST(TestTrackerOfCamera)

} // namespace carina::tracker_of_camera_test

#include "tst_tracker_of_camera.moc"
