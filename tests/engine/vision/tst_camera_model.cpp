#include "engine/vision/camera_model.h"
#include "tests/engine/vision/vision_bench.h"
#include "tests/support/test_class.h"

#include <opencv2/calib3d.hpp>

#include <limits>
#include <random>

namespace carina::camera_model_test
{
namespace
{

constexpr double kPixelTolerance = 1e-9;
constexpr double kSlopeTolerance = 1e-4; ///< pixels a metre, of several hundred
constexpr double kSightTolerance = 1e-9;

/// Where OpenCV sees a point of T, whose camera has +y down and looks along +z.
Vec2 seenByOpenCv(const CameraModel& camera, const Vec3& p_TQ)
{
    const std::vector<cv::Point3d> points{{p_TQ.x(), -p_TQ.y(), -p_TQ.z()}};
    const cv::Matx33d matrix{camera.focal.x(),
                             0.0,
                             camera.centre.x(),
                             0.0,
                             camera.focal.y(),
                             camera.centre.y(),
                             0.0,
                             0.0,
                             1.0};
    std::vector<cv::Point2d> pixels;
    cv::projectPoints(points, cv::Vec3d{0, 0, 0}, cv::Vec3d{0, 0, 0}, matrix,
                      std::vector<double>(camera.distortion.begin(), camera.distortion.end()),
                      pixels);
    return {pixels[0].x, pixels[0].y};
}

/// Points in the view of the webcam.
std::vector<Vec3> pointsInView()
{
    std::mt19937 random{7};
    std::uniform_real_distribution<double> share{-1.0, 1.0};
    std::vector<Vec3> points;
    for (int i = 0; i < 200; ++i) {
        const double away = 0.9 + 0.8 * share(random);
        points.push_back({0.55 * away * share(random), 0.4 * away * share(random), -away});
    }
    return points;
}

} // namespace

class TestCameraModel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void seesPointsWhereOpenCvDoes()
    {
        const CameraModel camera = vision_test::webcam();
        for (const Vec3& p_TQ : pointsInView()) {
            const auto pixel = project(camera, p_TQ);
            QVERIFY(pixel);
            QVERIFY((*pixel - seenByOpenCv(camera, p_TQ)).norm() < kPixelTolerance);
        }
    }

    void hasUpAndRightAsInThePicture()
    {
        const CameraModel camera = vision_test::webcam();
        QVERIFY(project(camera, {0.1, 0.0, -1.0})->x() > camera.centre.x());
        QVERIFY(project(camera, {0.0, 0.1, -1.0})->y() < camera.centre.y());
    }

    void seesNothingBehindItself()
    {
        QVERIFY(!project(vision_test::webcam(), {0.0, 0.0, 1.0}));
        QVERIFY(!project(vision_test::webcam(), Vec3::Zero()));
        QVERIFY(!project(vision_test::webcam(),
                         Vec3::Constant(std::numeric_limits<double>::quiet_NaN())));
    }

    void knowsHowAPixelMoves()
    {
        const CameraModel camera = vision_test::webcam();
        constexpr double kStep = 1e-6;
        for (const Vec3& p_TQ : pointsInView())
            for (int axis = 0; axis < 3; ++axis) {
                const Vec3 step = kStep * Vec3::Unit(axis);
                const Vec2 moved =
                    (*project(camera, p_TQ + step) - *project(camera, p_TQ - step)) / (2.0 * kStep);
                QVERIFY((moved - projectionSlope(camera, p_TQ).col(axis)).norm() < kSlopeTolerance);
            }
    }

    void looksBackAlongTheLineOfSight()
    {
        const CameraModel camera = vision_test::webcam();
        for (const Vec3& p_TQ : pointsInView()) {
            const Vec3 sight = sightOf(camera, *project(camera, p_TQ));
            QVERIFY((sight - p_TQ / -p_TQ.z()).norm() < kSightTolerance);
        }
    }

    void givesAFiniteSightWhereTheLensFoldsOver()
    {
        CameraModel camera = vision_test::webcam();
        camera.distortion = {-0.6, 0.0, 0.0, 0.0, 0.0};
        QVERIFY(sightOf(camera, {-4000.0, 9000.0}).allFinite());
    }

    void isUsableWithinReason_data()
    {
        QTest::addColumn<int>("width");
        QTest::addColumn<double>("focal");
        QTest::addColumn<double>("centre");
        QTest::addColumn<double>("k1");
        QTest::addColumn<bool>("usable");
        const double nan = std::numeric_limits<double>::quiet_NaN();
        QTest::newRow("a webcam") << 640 << 560.0 << 320.0 << 0.1 << true;
        QTest::newRow("no picture") << 0 << 560.0 << 320.0 << 0.1 << false;
        QTest::newRow("a huge picture") << 30'000 << 30'000.0 << 320.0 << 0.1 << false;
        QTest::newRow("no focal length") << 640 << 0.0 << 320.0 << 0.1 << false;
        QTest::newRow("an endless focal length") << 640 << 1e6 << 320.0 << 0.1 << false;
        QTest::newRow("a centre far away") << 640 << 560.0 << 5000.0 << 0.1 << false;
        QTest::newRow("a focal length that is no number") << 640 << nan << 320.0 << 0.1 << false;
        QTest::newRow("a distortion that is no number") << 640 << 560.0 << 320.0 << nan << false;
    }

    void isUsableWithinReason()
    {
        QFETCH(const int, width);
        QFETCH(const double, focal);
        QFETCH(const double, centre);
        QFETCH(const double, k1);
        QTEST(isUsable({.width = width,
                        .height = 480,
                        .focal = {focal, focal},
                        .centre = {centre, centre},
                        .distortion = {k1, 0.0, 0.0, 0.0, 0.0}}),
              "usable");
    }
};

CARINA_TEST(TestCameraModel)

} // namespace carina::camera_model_test

#include "tst_camera_model.moc"
