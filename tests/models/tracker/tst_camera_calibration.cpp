#include "models/tracker/camera_calibration.h"

#include "engine/io/site/devices/camera_file.h"
#include "tests/engine/vision/board_pictures.h"
#include "tests/support/patience.h"
#include "tests/support/test_class.h"

#include <QSignalSpy>
#include <QTemporaryDir>

namespace carina::camera_calibration_test
{
namespace
{

constexpr double kSquare_mm = 28.0;
constexpr double kFocalTolerance = 0.01; ///< share

} // namespace

class TestCameraCalibration : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void findsTheCameraOfPicturesOfTheBoard()
    {
        const QTemporaryDir folder;
        QVERIFY(vision_test::writeBoards(folder.path(), 30));
        CameraCalibration calibration;
        QSignalSpy changes{&calibration, &CameraCalibration::changed};
        QCOMPARE(calibration.text(), QString{});
        calibration.begin({folder.path(), {}, {640, 480}}, kSquare_mm);
        QTRY_VERIFY2_WITH_TIMEOUT(calibration.isFitted(), qPrintable(calibration.text()),
                                  kPatience_ms);
        QVERIFY(calibration.text().startsWith(QStringLiteral("✓")));
        const QString file = folder.filePath(QStringLiteral("camera.json"));
        QVERIFY(calibration.save(file));
        const auto camera = readCameraFile(file.toStdString());
        QVERIFY(camera);
        const double focal = vision_test::webcam().focal.x();
        QVERIFY(std::abs(camera->model.focal.x() - focal) < kFocalTolerance * focal);
        QVERIFY(camera->rms > 0.0 && !camera->madeAt.empty());
        QVERIFY(camera->pictures >= BoardCalibration::kFewestPictures);
        QVERIFY(changes.size() >= camera->pictures);
    }

    void asksForMoreUntilTheyAreEnough()
    {
        const QTemporaryDir folder;
        QVERIFY(vision_test::writeBoards(folder.path(), 4));
        CameraCalibration calibration;
        calibration.begin({folder.path(), {}, {}}, kSquare_mm);
        const auto asks = [&] {
            return calibration.text().contains(QStringLiteral("ten are needed"));
        };
        QTRY_VERIFY2_WITH_TIMEOUT(asks(), qPrintable(calibration.text()), kPatience_ms);
        QVERIFY(!calibration.isFitted());
        int corners = 0;
        for (const int ninth : calibration.coverage())
            corners += ninth;
        QVERIFY(corners > 0);
    }

    void saysThatNoCameraIsThere()
    {
        CameraCalibration calibration;
        calibration.begin({QStringLiteral("/dev/no-such-camera"), {}, {640, 480}}, kSquare_mm);
        const auto tells = [&] {
            return calibration.text().contains(QStringLiteral("/dev/no-such-camera"));
        };
        QTRY_VERIFY2_WITH_TIMEOUT(tells(), qPrintable(calibration.text()), kPatience_ms);
        calibration.end();
        QVERIFY(tells());
    }

    void knowsTheCameraOfATracker()
    {
        QVERIFY(!cameraOf({SimulatedDevice{}}));
        QVERIFY(!cameraOf({TrackerDescription{.address = "/dev/ttyUSB0"}}));
        TrackerDescription described{.address = "/dev/video3", .kind = TrackerKind::Camera};
        described.camera = vision_test::webcam();
        described.calibration = "somewhere/camera.json";
        const auto camera = cameraOf({described});
        QVERIFY(camera);
        QCOMPARE(camera->place, QStringLiteral("/dev/video3"));
        QCOMPARE(camera->file, QStringLiteral("somewhere/camera.json"));
        QCOMPARE(camera->size, (QSize{640, 480}));
        QCOMPARE(trackerName({described}), QStringLiteral("Markers before the camera /dev/video3"));
    }

    void writesBesideACalibrationOfOpenCv()
    {
        const QTemporaryDir folder;
        const QString own = folder.filePath(QStringLiteral("lens.json"));
        TrackerDescription described{.address = "/dev/video3", .kind = TrackerKind::Camera};
        described.camera = vision_test::webcam();
        described.calibration = folder.filePath(QStringLiteral("lens.yml")).toStdString();
        QCOMPARE(cameraOf({described})->file, own);
        QFile there{own};
        QVERIFY(there.open(QIODevice::WriteOnly));
        QCOMPARE(cameraOf({described})->file, folder.filePath(QStringLiteral("lens-2.json")));
    }
};

CARINA_TEST(TestCameraCalibration)

} // namespace carina::camera_calibration_test

#include "tst_camera_calibration.moc"
