#include "engine/geometry/rotation.h"
#include "engine/vision/body_pose.h"
#include "tests/engine/vision/stated_covariance.h"
#include "tests/engine/vision/vision_bench.h"
#include "tests/support/test_class.h"

#include <Eigen/Cholesky>

#include <cmath>
#include <random>

namespace carina::body_pose_test
{
namespace
{

constexpr double kLengthTolerance = 1e-8; ///< metres
constexpr double kAngleTolerance = 1e-7;  ///< radians
constexpr int kDraws = 2000;
/// Of a mean over the draws, as a share: four standard errors, of 0.015 each, and what the
/// projection is off the straight line.
constexpr double kOfTheMean = 0.08;

std::vector<SeenCorner> seenExactly(const MarkerBody& body, const RigidTransform& X_TB)
{
    std::vector<SeenCorner> corners;
    for (const BodyMarker& marker : body)
        for (const Vec3& p_BQ : cornersOf(marker))
            corners.push_back({p_BQ, *project(vision_test::webcam(), X_TB * p_BQ)});
    return corners;
}

bool isNear(const RigidTransform& X, const RigidTransform& truth)
{
    return (X.translation() - truth.translation()).norm() < kLengthTolerance
           && angleBetween(X.rotation(), truth.rotation()).si < kAngleTolerance;
}

Eigen::Matrix<double, 6, 1> errorOf(const RigidTransform& found, const RigidTransform& truth)
{
    Eigen::Matrix<double, 6, 1> error;
    const Vec3 w = rotationVector(truth.rotation() * found.rotation().conjugate());
    error << w, truth.translation() - found.translation() - w.cross(found.translation());
    return error;
}

} // namespace

class TestBodyPose : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void recoversAKnownPose_data()
    {
        QTest::addColumn<QString>("tool");
        QTest::addColumn<double>("tilt");
        QTest::newRow("flat, four markers") << QStringLiteral("Manikin") << 35.0;
        QTest::newRow("flat, two markers") << QStringLiteral("Chin") << -40.0;
        QTest::newRow("a sleeve") << QStringLiteral("Tube") << 70.0;
    }

    void recoversAKnownPose()
    {
        QFETCH(const QString, tool);
        QFETCH(const double, tilt);
        const MarkerBody& body = vision_test::printed(tool.toStdString()).body;
        for (const double direction : {0.0, 50.0, 130.0, 250.0}) {
            const RigidTransform X_TB =
                vision_test::facing({0.08, -0.05, -0.5}, tilt, direction, 20.0);
            const auto fit = fitBody(vision_test::webcam(), seenExactly(body, X_TB));
            QVERIFY(fit);
            QVERIFY(isNear(fit->best.X_TB, X_TB));
            QVERIFY(fit->best.rms < 1e-6);
        }
    }

    /// For a single marker the other minimum is tilted to the other side.
    void findsTheMirrorImageOfAFlatMarker()
    {
        const MarkerBody marker{{0, 0.03, {}}};
        const RigidTransform X_TB = vision_test::facing({0.0, 0.0, -0.8}, 30.0);
        const auto fit = fitBody(vision_test::webcam(), seenExactly(marker, X_TB));
        QVERIFY(fit && fit->rival);
        QVERIFY(isNear(fit->best.X_TB, X_TB));
        const Vec3 normal = fit->rival->X_TB.rotation() * Vec3::UnitZ();
        const Vec3 truth = X_TB.rotation() * Vec3::UnitZ();
        QVERIFY(std::abs(normal.y() + truth.y()) < 0.1);
        QVERIFY(fit->evidence > 0.0);
    }

    void isSurerTheLargerAMarkerIsSeen()
    {
        const MarkerBody marker{{0, 0.03, {}}};
        double before = 0.0;
        for (const double away : {1.2, 0.8, 0.5, 0.3}) {
            const auto fit =
                fitBody(vision_test::webcam(),
                        seenExactly(marker, vision_test::facing({0.0, 0.0, -away}, 30.0)));
            QVERIFY(fit && fit->rival && fit->evidence > before);
            before = fit->evidence;
        }
    }

    /// With corners off by Gaussian noise the error, squared over the stated covariance, has six
    /// degrees of freedom. Where the noise is another than the assumed one, the residuals of 16
    /// corners tell: at 0.3 times it the mean square is 0.43 instead of 0.09, at twice 1.20 instead
    /// of 4.
    void statesTheCovarianceOfItsError_data()
    {
        QTest::addColumn<QString>("tool");
        QTest::addColumn<double>("noise_px");
        for (const char* tool : {"Manikin", "Tube"})
            for (const double noise : {0.045, 0.15, 0.30})
                QTest::addRow("%s, %g pixels", tool, noise) << QString::fromLatin1(tool) << noise;
    }

    void statesTheCovarianceOfItsError()
    {
        QFETCH(const QString, tool);
        QFETCH(const double, noise_px);
        const MarkerBody& body = vision_test::printed(tool.toStdString()).body;
        const RigidTransform X_TB = vision_test::facing({0.05, 0.08, -0.6}, 40.0, 25.0, 10.0);
        const std::vector<SeenCorner> exact = seenExactly(body, X_TB);
        std::mt19937 random{7};
        std::normal_distribution<double> noise{0.0, noise_px};
        double squares = 0.0;
        for (int i = 0; i < kDraws; ++i) {
            std::vector<SeenCorner> corners = exact;
            for (SeenCorner& corner : corners)
                corner.pixel += Vec2{noise(random), noise(random)};
            const auto fit = fitBody(vision_test::webcam(), corners);
            QVERIFY(fit);
            QVERIFY(isCovariance(fit->best.covariance_T));
            const auto error = errorOf(fit->best.X_TB, X_TB);
            squares += error.dot(fit->best.covariance_T.ldlt().solve(error)) / 6.0 / kDraws;
        }
        const double expected = vision_test::expectedSquare(noise_px, 2 * int(exact.size()) - 6);
        QVERIFY2(std::abs(squares / expected - 1.0) < kOfTheMean,
                 qPrintable(QStringLiteral("%1, expected %2").arg(squares).arg(expected)));
    }

    void hasNoPoseOfTooLittle()
    {
        QVERIFY(!fitBody(vision_test::webcam(), {}));
        std::vector<SeenCorner> corners = seenExactly(vision_test::printed("Chin").body,
                                                      vision_test::facing({0.0, 0.0, -0.5}, 20.0));
        corners.resize(3);
        QVERIFY(!fitBody(vision_test::webcam(), corners));
        const std::vector<SeenCorner> oneSpot(8, {Vec3::Zero(), {100.0, 100.0}});
        QVERIFY(!fitBody(vision_test::webcam(), oneSpot));
    }
};

CARINA_TEST(TestBodyPose)

} // namespace carina::body_pose_test

#include "tst_body_pose.moc"
