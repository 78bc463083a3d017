#include "engine/vision/board_calibration.h"
#include "evaluation/vision/marker_renderer.h"
#include "tests/engine/vision/vision_bench.h"
#include "tests/support/test_class.h"

#include <opencv2/aruco/charuco.hpp>

#include <memory>
#include <random>

namespace carina::board_calibration_test
{
namespace
{

constexpr double kFocalTolerance = 0.005; ///< share
constexpr double kCentreTolerance = 4.0;  ///< pixels
constexpr double kSeenTolerance = 3.0;    ///< pixels, anywhere in the picture

const CalibrationBoard kBoard;

/// How a set of pictures is taken.
struct Taking {
    int pictures = 24;
    double tilt_deg = 35.0;
    double reach = 0.75; ///< share of the picture's half that the board's middle goes to
};

std::unique_ptr<BoardCalibration> calibrated(const Taking& taking)
{
    const CameraModel camera = vision_test::webcam();
    MarkerRenderer renderer{camera, kBoard.dictionary, {.samples = 2, .noise = 1.5}};
    std::mt19937 random{7};
    std::uniform_real_distribution<double> share{-1.0, 1.0};
    auto calibration = std::make_unique<BoardCalibration>(kBoard);
    for (int i = 0; i < taking.pictures; ++i) {
        const double across = taking.reach * share(random);
        const double down = taking.reach * share(random);
        const Vec2 middle{320.0 * (1.0 + across), 240.0 * (1.0 + down)};
        const Vec3 p_T = (0.42 + 0.1 * share(random)) * sightOf(camera, middle).normalized();
        const double direction_deg = 180.0 * share(random);
        const double turn_deg = 90.0 * share(random);
        const RigidTransform X_TB =
            taking.tilt_deg == 0.0 // parallel to the picture
                ? RigidTransform{Quat{Eigen::AngleAxisd{degrees(turn_deg).si, Vec3::UnitZ()}}, p_T}
                : vision_test::facing(p_T, taking.tilt_deg * (i % 2 ? 1 : -1), direction_deg,
                                      turn_deg);
        static_cast<void>(
            calibration->add(renderer.drawBoard({cellsOf(kBoard), kBoard.columns * kCellsOfSquare,
                                                 kBoard.square / kCellsOfSquare, X_TB})));
    }
    return calibration;
}

} // namespace

class TestBoardCalibration : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void findsTheCameraThatTookThePictures()
    {
        const CameraModel truth = vision_test::webcam();
        const auto fitted = calibrated({})->fit();
        const auto* fit = std::get_if<BoardFit>(&fitted);
        QVERIFY(fit != nullptr);
        QVERIFY(fit->rms < 0.3);
        QVERIFY(fit->pictures >= 15);
        QVERIFY((fit->camera.focal - truth.focal).norm() < kFocalTolerance * truth.focal.norm());
        QVERIFY((fit->camera.centre - truth.centre).norm() < kCentreTolerance);
        for (double x = 20.0; x < 640.0; x += 60.0)
            for (double y = 20.0; y < 480.0; y += 40.0) {
                const Vec3 sight = sightOf(truth, {x, y});
                const double off = (*project(fit->camera, sight) - Vec2{x, y}).norm();
                QVERIFY2(off < kSeenTolerance, qPrintable(QString::number(off)));
            }
    }

    void refusesASetThatDeterminesNoCamera_data()
    {
        QTest::addColumn<int>("pictures");
        QTest::addColumn<double>("tilt");
        QTest::addColumn<double>("reach");
        QTest::addColumn<CalibrationFault>("fault");
        QTest::newRow("few") << 6 << 35.0 << 0.75 << CalibrationFault::TooFewPictures;
        QTest::newRow("none into a corner") << 30 << 35.0 << 0.12 << CalibrationFault::NotAllOver;
        QTest::newRow("none tilted") << 30 << 0.0 << 0.8 << CalibrationFault::NotTilted;
    }

    void refusesASetThatDeterminesNoCamera()
    {
        QFETCH(const int, pictures);
        QFETCH(const double, tilt);
        QFETCH(const double, reach);
        QFETCH(const CalibrationFault, fault);
        const auto fitted =
            calibrated({.pictures = pictures, .tilt_deg = tilt, .reach = reach})->fit();
        const auto* found = std::get_if<CalibrationFault>(&fitted);
        QVERIFY(found != nullptr);
        QCOMPARE(*found, fault);
    }

    void keepsAPlaceOnce()
    {
        MarkerRenderer renderer{vision_test::webcam(), kBoard.dictionary, {.samples = 2}};
        const GreyPicture picture = renderer.drawBoard(
            {cellsOf(kBoard), kBoard.columns * kCellsOfSquare, kBoard.square / kCellsOfSquare,
             vision_test::facing({0.0, 0.0, -0.45}, 20.0)});
        BoardCalibration calibration{kBoard};
        QCOMPARE(calibration.add(picture), std::optional{24}); // 4 x 6 inner corners
        QVERIFY(!calibration.add(picture));
        QCOMPARE(calibration.pictures(), 1);
        QVERIFY(!BoardCalibration{kBoard}.add(renderer.draw({})));
    }

    /// The cells against OpenCV's own drawing of the board at another size.
    void printsTheBoardThatOpenCvLooksFor()
    {
        const auto board = cv::aruco::CharucoBoard::create(
            kBoard.columns, kBoard.rows, 9.0F, 7.0F,
            cv::aruco::getPredefinedDictionary(int(kBoard.dictionary)));
        cv::Mat drawn;
        const int columns = kBoard.columns * kCellsOfSquare;
        const int rows = kBoard.rows * kCellsOfSquare;
        board->draw({columns * 12, rows * 12}, drawn);
        const auto cells = cellsOf(kBoard);
        QCOMPARE(cells.size(), std::size_t(columns * rows));
        for (int row = 0; row < rows; ++row)
            for (int column = 0; column < columns; ++column)
                QCOMPARE(bool(cells[std::size_t(row * columns + column)]),
                         drawn.at<unsigned char>(row * 12 + 6, column * 12 + 6) > 127);
    }
};

CARINA_TEST(TestBoardCalibration)

} // namespace carina::board_calibration_test

#include "tst_board_calibration.moc"
