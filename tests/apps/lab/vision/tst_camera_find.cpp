#include "apps/lab/commands.h"
#include "apps/lab/vision/still_jitter.h"
#include "engine/geometry/rotation.h"
#include "tests/support/test_class.h"
#include "tests/support/test_data.h"

#include <QJsonArray>
#include <QJsonObject>
#include <QTemporaryDir>

#include <random>

namespace carina::lab::camera_find_test
{
namespace
{

double numberIn(const QJsonObject& object, const char* key)
{
    return object[QLatin1StringView{key}].toDouble(std::nan(""));
}

} // namespace

class TestCameraFind : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// A video of IGSTK, which was enlarged after its calibration. Its marker is on a card that
    /// leans on a pencil and is bent: the corners are a hundredth of the marker's side, 430
    /// pixels, from where any pose of a flat one puts them.
    void hasPosesInARecordedVideo()
    {
        const auto video = test::testData("tracker/aruco/ArucoSimulationVideo.avi");
        const auto camera = test::testData("tracker/aruco/ArucoCalibrationFile.yml");
        if (!video || !camera)
            QSKIP("no tracker/aruco in the test data");
        const auto seen = cameraCommand().run(
            {QStringLiteral("find"), QString::fromStdString(video->string()),
             QStringLiteral("--calibration"), QString::fromStdString(camera->string())});
        QVERIFY2(seen, seen ? "" : seen.error().detail.c_str());
        QCOMPARE(numberIn(*seen, "pictures"), 63.0);
        QCOMPARE(numberIn(*seen, "with_marker"), 63.0);
        QCOMPARE(numberIn(*seen, "with_pose"), 63.0);
        const QJsonArray markers = (*seen)[QStringLiteral("markers")].toArray();
        QCOMPARE(markers.size(), 1);
        QVERIFY(numberIn(markers[0].toObject(), "reprojection_px") < 4.3); // 1 % of the side
        QVERIFY(numberIn(markers[0].toObject(), "jitter_mm") < 0.3);
    }

    /// The video that the laboratory renders, looked at by the laboratory.
    void findsTheMarkersOfARenderedVideo()
    {
        const QTemporaryDir folder;
        const auto rendered = cameraCommand().run(
            {QStringLiteral("video"), folder.path(), QStringLiteral("--seconds"),
             QStringLiteral("1"), QStringLiteral("--rate"), QStringLiteral("5"),
             QStringLiteral("--width"), QStringLiteral("640")});
        QVERIFY2(rendered, rendered ? "" : rendered.error().detail.c_str());
        QCOMPARE(numberIn(*rendered, "pictures"), 5.0);
        const auto seen = cameraCommand().run(
            {QStringLiteral("find"), folder.filePath(QStringLiteral("markers.avi")),
             QStringLiteral("--calibration"),
             folder.filePath(QStringLiteral("tracker-camera.json")), QStringLiteral("--dictionary"),
             QStringLiteral("4x4_50"), QStringLiteral("--side-mm"), QStringLiteral("27")});
        QVERIFY2(seen, seen ? "" : seen.error().detail.c_str());
        QCOMPARE(numberIn(*seen, "pictures"), 5.0);
        QCOMPARE(numberIn(*seen, "with_pose"), 5.0);
        // Three of the chest, since the sheet of the chin hides the fourth, both of the chin, and
        // one or more of each of two sleeves.
        QVERIFY((*seen)[QStringLiteral("markers")].toArray().size() >= 7);
    }

    /// The poses that a tracker finds in the compressed video are those that were rendered. Of 20
    /// seconds the largest RMS of a tool and distance are 0.15 mm, 6.2 mm (the chin, whose sheet is
    /// small) and 1.2 degrees; of ten pictures they may be half as large again.
    void findsTheRenderedPosesAgain()
    {
        const QTemporaryDir folder;
        const auto rendered = cameraCommand().run({QStringLiteral("video"), folder.path(),
                                                   QStringLiteral("--seconds"), QStringLiteral("2"),
                                                   QStringLiteral("--rate"), QStringLiteral("5"),
                                                   QStringLiteral("--compare")});
        QVERIFY2(rendered, rendered ? "" : rendered.error().detail.c_str());
        const QJsonArray compared = (*rendered)[QStringLiteral("compared")].toArray();
        QVERIFY(compared.size() >= 3); // chest, chin, tube
        for (const QJsonValue& value : compared) {
            const QJsonObject tool = value.toObject();
            if (numberIn(tool, "seen") == 0.0)
                continue;
            const auto name = tool[QStringLiteral("tool")].toString();
            QCOMPARE(numberIn(tool, "wrong"), 0.0);
            QVERIFY2(numberIn(tool, "across_mm") < 0.3, qPrintable(name));
            QVERIFY2(numberIn(tool, "along_mm") < 10.0, qPrintable(name));
            QVERIFY2(numberIn(tool, "rotation_deg") < 2.0, qPrintable(name));
        }
    }

    void refusesWhatItCannotUse_data()
    {
        QTest::addColumn<QStringList>("words");
        QTest::addColumn<Errc>("code");
        QTest::newRow("nothing") << QStringList{} << Errc::WrongOption;
        QTest::newRow("no calibration")
            << QStringList{QStringLiteral("find"), QStringLiteral("a.avi")} << Errc::WrongOption;
        QTest::newRow("a webcam") << QStringList{QStringLiteral("find"),
                                                 QStringLiteral("/dev/video0"),
                                                 QStringLiteral("--calibration"),
                                                 QStringLiteral("a.json")}
                                  << Errc::WrongOption;
        QTest::newRow("no such file")
            << QStringList{QStringLiteral("find"), QStringLiteral("none.avi"),
                           QStringLiteral("--calibration"), QStringLiteral("none.json")}
            << Errc::FileNotFound;
    }

    void refusesWhatItCannotUse()
    {
        QFETCH(const QStringList, words);
        QFETCH(const Errc, code);
        const auto seen = cameraCommand().run(words);
        QVERIFY(!seen);
        QCOMPARE(seen.error().code, code);
    }

    void measuresHowMuchAStillToolScatters()
    {
        constexpr double kNoise = 0.2e-3; // metres, along each axis
        std::mt19937 random{7};
        std::normal_distribution<double> noise{0.0, kNoise};
        StillJitter jitter;
        for (int i = 0; i < 2000; ++i)
            jitter.add(RigidTransform::translation({noise(random), noise(random), noise(random)}));
        QVERIFY(jitter.samples() > 1500);
        QVERIFY(std::abs(*jitter.position_mm() / (1e3 * kNoise * std::sqrt(3.0)) - 1.0) < 0.1);
        QVERIFY(*jitter.rotation_deg() < 1e-6);
    }

    void measuresNothingOfAToolThatMoves()
    {
        StillJitter jitter;
        for (int i = 0; i < 100; ++i)
            jitter.add(RigidTransform::translation({1e-3 * i, 0.0, 0.0}));
        QCOMPARE(jitter.samples(), 0);
        QVERIFY(!jitter.position_mm() && !jitter.rotation_deg());
    }
};

CARINA_TEST(TestCameraFind)

} // namespace carina::lab::camera_find_test

#include "tst_camera_find.moc"
