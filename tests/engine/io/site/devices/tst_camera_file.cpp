#include "engine/io/site/devices/camera_file.h"

#include "engine/io/site/devices/camera_yaml.h"
#include "engine/io/site/devices/marker_file.h"
#include "tests/support/test_class.h"
#include "tests/support/test_data.h"

#include <QTemporaryDir>

#include <fstream>

namespace carina::camera_file_test
{
namespace
{

const QByteArray kCamera = R"({"schema": "carina.camera/1", "width": 640, "height": 480,
    "focal_px": [560.5, 557], "centre_px": [322, 236.25], "distortion": [0.1, -0.2, 0.001, 0.002, 0],
    "rms_px": 0.31, "pictures": 21, "made_at": "2004-03-27T10:15:00Z"})";
const QByteArray kYaml = R"(%YAML:1.0
image_width: 640
image_height: 480
camera_matrix: !!opencv-matrix
   rows: 3
   cols: 3
   dt: d
   data: [ 7.09e+002, 0., 332.5, 0.,
       +705.25, 226., 0., 0., 1. ]
distortion_coefficients: !!opencv-matrix
   rows: 1
   cols: 4
   dt: d
   data: [ 8.25e-002, -0.5, 5e-3, -1.5e-002 ]
)";
const QByteArray kMarkers = R"({"schema": "carina.markers/1", "dictionary": "4x4_50", "markers": [
    {"id": 6, "side_mm": 27, "X_BK_mm": [[0, 0, 1, 18], [1, 0, 0, 0], [0, 1, 0, 18], [0, 0, 0, 1]]},
    {"id": 7, "side_mm": 20, "X_BK_mm": [[1, 0, 0, 5], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]}]})";

/// A file with these bytes, in a folder of its own.
class Written
{
public:
    Written(const char* name, const QByteArray& bytes)
        : m_path{m_folder.filePath(QString::fromLatin1(name)).toStdString()}
    {
        std::ofstream{m_path, std::ios::binary}.write(bytes.constData(), bytes.size());
    }
    [[nodiscard]] const std::string& path() const { return m_path; }

private:
    QTemporaryDir m_folder;
    std::string m_path;
};

} // namespace

/// Calibrations of cameras and the markers of bodies.
class TestCameraFile : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void readsACamera()
    {
        const auto camera = readCameraFile(Written{"camera.json", kCamera}.path());
        QVERIFY2(camera, camera ? "" : camera.error().detail.c_str());
        QCOMPARE(camera->model.width, 640);
        QCOMPARE(camera->model.height, 480);
        QCOMPARE(camera->model.focal, (Vec2{560.5, 557.0}));
        QCOMPARE(camera->model.centre, (Vec2{322.0, 236.25}));
        QCOMPARE(camera->model.distortion[1], -0.2);
        QCOMPARE(camera->rms, 0.31);
        QCOMPARE(camera->pictures, 21);
        QCOMPARE(camera->madeAt, std::string{"2004-03-27T10:15:00Z"});
    }

    void readsTheCameraThatItWrote()
    {
        const Written file{"camera.json", kCamera};
        const auto camera = readCameraFile(file.path());
        QVERIFY(camera && writeCameraFile(file.path(), *camera));
        const auto again = readCameraFile(file.path());
        QVERIFY(again);
        QCOMPARE(again->model.focal, camera->model.focal);
        QVERIFY(again->model.distortion == camera->model.distortion);
        QCOMPARE(again->madeAt, camera->madeAt);
        QVERIFY(writeCameraFile(file.path(), {.model = camera->model}));
        QCOMPARE(readCameraFile(file.path())->pictures, 0);
    }

    void readsACameraOfOpenCv()
    {
        const auto camera = readCameraFile(Written{"camera.yml", kYaml}.path());
        QVERIFY2(camera, camera ? "" : camera.error().detail.c_str());
        QCOMPARE(camera->model.width, 640);
        QCOMPARE(camera->model.focal, (Vec2{709.0, 705.25}));
        QCOMPARE(camera->model.centre, (Vec2{332.5, 226.0}));
        QVERIFY((camera->model.distortion == std::array{0.0825, -0.5, 0.005, -0.015, 0.0}));
    }

    void readsTheCameraOfARecordedVideo()
    {
        const auto file = test::testData("tracker/aruco/ArucoCalibrationFile.yml");
        if (!file)
            QSKIP("no tracker/aruco in the test data");
        const auto camera = readCameraFile(*file);
        QVERIFY2(camera, camera ? "" : camera.error().detail.c_str());
        QCOMPARE(camera->model.focal.y(), 705.04208713369007);
        QCOMPARE(camera->model.distortion[3], -0.016956711033663380);
    }

    void namesWhatIsWrongWithACamera_data()
    {
        QTest::addColumn<QByteArray>("name");
        QTest::addColumn<QByteArray>("before");
        QTest::addColumn<QByteArray>("after");
        QTest::addColumn<QByteArray>("named");
        const auto row = [](const char* tag, const char* name, const char* before,
                            const char* after, const char* named) {
            QTest::newRow(tag) << QByteArray{name} << QByteArray{before} << QByteArray{after}
                               << QByteArray{named};
        };
        row("no width", "a.json", R"("width": 640)", R"("width": "x")", "width");
        row("one focal length", "a.json", "[560.5, 557]", "[560.5]", "focal_px");
        row("an unknown field", "a.json", R"("pictures")", R"("frames")", "frames");
        row("no camera", "a.json", "560.5", "0", "no camera");
        row("no width in YAML", "a.yml", "image_width", "image_size", "image_width");
        row("half a picture", "a.yml", "640", "640.5", "image_width");
        row("no matrix", "a.yml", "camera_matrix", "matrix", "camera_matrix");
        row("a cut matrix", "a.yml", "0., 0., 1. ]", "0., 0.,", "camera_matrix");
        row("a small matrix", "a.yml", "0., 0., 1. ]", "0. ]", "camera_matrix");
        row("a matrix without data", "a.yml", "data: [ 7", "list: [ 7", "camera_matrix");
        row("too little distortion", "a.yml", "-0.5, 5e-3, -1.5e-002", "-0.5",
            "distortion_coefficients");
        row("another lens", "a.yml", "-1.5e-002", "-1.5e-002, 0, 0.5", "another model");
    }

    void namesWhatIsWrongWithACamera()
    {
        QFETCH(const QByteArray, name);
        QFETCH(const QByteArray, before);
        QFETCH(const QByteArray, after);
        QFETCH(const QByteArray, named);
        QByteArray text = name.endsWith("yml") ? kYaml : kCamera;
        QVERIFY(text.contains(before));
        const auto camera =
            readCameraFile(Written{name.constData(), text.replace(before, after)}.path());
        QVERIFY(!camera);
        QCOMPARE(camera.error().code, Errc::FileMalformed);
        QVERIFY2(QByteArray::fromStdString(camera.error().detail).contains(named),
                 camera.error().detail.c_str());
        QVERIFY(camera.error().detail.find(name.toStdString()) != std::string::npos);
    }

    void writesNoFileOfOpenCv()
    {
        const Written file{"lens.yml", "the camera of somebody"};
        const auto wrote = writeCameraFile(file.path(), {});
        QVERIFY(!wrote);
        QCOMPARE(wrote.error().code, Errc::FileUnwritable);
        QCOMPARE(std::filesystem::file_size(file.path()), std::uintmax_t{22});
    }

    void readsTheMarkersThatItWrote()
    {
        const Written file{"tube.json", kMarkers};
        const auto body = readMarkerFile(file.path());
        QVERIFY2(body, body ? "" : body.error().detail.c_str());
        QCOMPARE(body->dictionary, MarkerDictionary::Bits4Of50);
        QCOMPARE(body->markers.size(), std::size_t{2});
        QCOMPARE(body->markers[0].id, 6);
        QCOMPARE(body->markers[0].side, 0.027);
        QVERIFY((body->markers[0].X_BK * Vec3{0.0, 0.0, 0.01} - Vec3{0.028, 0.0, 0.018}).norm()
                < 1e-12);
        QVERIFY(writeMarkerFile(file.path(), *body));
        const auto again = readMarkerFile(file.path());
        QVERIFY(again);
        QCOMPARE(again->markers[1].id, 7);
        QVERIFY(again->markers[1].X_BK.matrix().isApprox(body->markers[1].X_BK.matrix()));
    }

    void namesWhatIsWrongWithMarkers_data()
    {
        QTest::addColumn<QByteArray>("before");
        QTest::addColumn<QByteArray>("after");
        QTest::addColumn<QByteArray>("named");
        const auto row = [](const char* tag, const char* before, const char* after,
                            const char* named) {
            QTest::newRow(tag) << QByteArray{before} << QByteArray{after} << QByteArray{named};
        };
        row("an unknown dictionary", "4x4_50", "3x3_8", "dictionary");
        row("a marker that is not in it", R"("id": 6)", R"("id": 50)", "marker 50");
        row("a marker twice", R"("id": 6)", R"("id": 7)", "marker 7");
        row("no size", R"("side_mm": 27)", R"("side_mm": 0)", "marker 6");
        row("a mirrored marker", "[[0, 0, 1, 18]", "[[0, 0, -1, 18]", "markers[0].X_BK_mm");
        row("an unknown field", R"("side_mm": 20)", R"("side": 20)", "markers[1].side");
        row("no markers", "markers\"", "none\"", "none");
    }

    void namesWhatIsWrongWithMarkers()
    {
        QFETCH(const QByteArray, before);
        QFETCH(const QByteArray, after);
        QFETCH(const QByteArray, named);
        QByteArray text = kMarkers;
        const qsizetype at = text.lastIndexOf(before);
        QVERIFY(at >= 0);
        const auto body =
            readMarkerFile(Written{"tube.json", text.replace(at, before.size(), after)}.path());
        QVERIFY(!body);
        QCOMPARE(body.error().code, Errc::FileMalformed);
        QVERIFY2(QByteArray::fromStdString(body.error().detail).contains(named),
                 body.error().detail.c_str());
    }
};

CARINA_TEST(TestCameraFile)

} // namespace carina::camera_file_test

#include "tst_camera_file.moc"
