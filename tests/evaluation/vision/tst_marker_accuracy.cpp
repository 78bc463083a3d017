#include "engine/geometry/rotation.h"
#include "engine/vision/printed_tools.h"
#include "evaluation/vision/marker_accuracy.h"
#include "tests/engine/vision/stated_covariance.h"
#include "tests/engine/vision/vision_bench.h"
#include "tests/evaluation/vision/propagated_error.h"
#include "tests/support/test_class.h"

#include <random>
#include <vector>

namespace carina::marker_accuracy_test
{
namespace
{

constexpr int kPosesStated = 40; ///< of accuracyOf()
/// How much smaller than for independent corners the errors of a sheet of four markers may be,
/// squared: a line through an edge is shared by two corners, whose errors partly cancel in the
/// pose.
constexpr double kSharedEdges = 8.0;

MarkerAccuracy accuracyOf(const std::string& tool, double distance)
{
    const PrintedTool& printed = vision_test::printed(tool);
    return markerAccuracy({.camera = vision_test::webcam(),
                           .dictionary = kPrintedDictionary,
                           .body = printed.body,
                           .rendering = {},
                           .distance = distance,
                           .isTurning = printed.isSleeve,
                           .poses = kPosesStated});
}

constexpr int kPoses = 60;
constexpr double kSecondOrder = 0.05; ///< of the error, for corners that are off by a few tenths

/// Mean squares of the errors of poses.
struct PoseSquares {
    double across = 0.0;   ///< of the origin along each axis across the line of sight, m^2
    double along = 0.0;    ///< m^2
    double rotation = 0.0; ///< rad^2

    void add(const Vec3& turn, const Vec3& shift, const Vec3& sight)
    {
        const double depth = shift.dot(sight.normalized());
        across += 0.5 * (shift.squaredNorm() - depth * depth);
        along += depth * depth;
        rotation += turn.squaredNorm();
    }
};

struct Comparison {
    PoseSquares found;
    PoseSquares propagated; ///< from the corners that were seen
    int seen = 0;
};

test::PinholeCamera pinhole()
{
    const CameraModel camera = vision_test::webcam();
    return {camera.focal, camera.centre, camera.distortion};
}

/// The tool at a pose of a series: all over the middle of the picture, tilted by up to 50 degrees.
RigidTransform poseOf(const PrintedTool& tool, double distance, std::mt19937& random)
{
    std::uniform_real_distribution<double> share{-1.0, 1.0};
    const Vec3 p_T = distance * Vec3{0.2 * share(random), 0.15 * share(random), -1.0}.normalized();
    const double tilt = 50.0 * share(random);
    const double direction = 180.0 * share(random);
    const double turn = 180.0 * share(random);
    if (!tool.isSleeve)
        return vision_test::facing(p_T, tilt, direction, turn);
    // Its axis is z: across the line of sight before it is tilted.
    return vision_test::facing(p_T, 90.0 + 0.5 * tilt, direction, turn);
}

std::vector<test::CornerAt> cornersIn(const std::vector<DetectedMarker>& seen,
                                      const MarkerBody& body)
{
    std::vector<test::CornerAt> corners;
    for (const DetectedMarker& marker : seen) {
        const auto of = std::ranges::find(body, marker.id, &BodyMarker::id);
        if (of == body.end())
            continue;
        const auto p_BQ = cornersOf(*of);
        for (std::size_t i = 0; i < p_BQ.size(); ++i)
            corners.push_back({p_BQ[i], marker.corners[i]});
    }
    return corners;
}

Comparison compared(const PrintedTool& tool, double distance)
{
    MarkerRenderer renderer{vision_test::webcam(), kPrintedDictionary, {}};
    std::mt19937 random{3};
    Comparison sum;
    for (int i = 0; i < kPoses; ++i) {
        const RigidTransform X_TB = poseOf(tool, distance, random);
        const PosedBody placed{&tool.body, X_TB};
        const auto seen = seenMarkers(renderer.draw({&placed, 1}), kPrintedDictionary);
        MarkerWatch watch{{vision_test::webcam(), kPrintedDictionary, {tool.body}}};
        const BodySight sight = watch.look(seen, {}).front();
        if (!sight.pose || sight.isAmbiguous)
            continue;
        ++sum.seen;
        const RigidTransform& found = sight.pose->X_TB;
        const Vec3& p_TB = X_TB.translation();
        sum.found.add(rotationVector(found.rotation() * X_TB.rotation().conjugate()),
                      found.translation() - p_TB, p_TB);
        const Vec6 error = test::propagatedError(pinhole(), X_TB, cornersIn(seen, tool.body));
        sum.propagated.add(error.head<3>(), error.tail<3>(), p_TB);
    }
    return sum;
}

} // namespace

/// The camera tracker on rendered pictures of 640 by 480 pixels, against the poses rendered.
class TestMarkerAccuracy : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isAsGoodAsItsCorners_data()
    {
        QTest::addColumn<QString>("tool");
        QTest::addColumn<double>("distance");
        QTest::newRow("chest at 0.4 m") << QStringLiteral("Manikin") << 0.4;
        QTest::newRow("chest at 0.8 m") << QStringLiteral("Manikin") << 0.8;
        QTest::newRow("tube at 0.3 m") << QStringLiteral("Tube") << 0.3;
        QTest::newRow("tube at 0.5 m") << QStringLiteral("Tube") << 0.5;
    }

    /// No more than what the corners are off by, propagated by other code to first order.
    void isAsGoodAsItsCorners()
    {
        QFETCH(const QString, tool);
        QFETCH(const double, distance);
        const Comparison sum = compared(vision_test::printed(tool.toStdString()), distance);
        const double across = std::sqrt(sum.found.across / sum.propagated.across);
        const double along = std::sqrt(sum.found.along / sum.propagated.along);
        const double rotation = std::sqrt(sum.found.rotation / sum.propagated.rotation);
        const QString told = QStringLiteral("of what is propagated: across %1, along %2, rotation "
                                            "%3; %4 poses")
                                 .arg(across)
                                 .arg(along)
                                 .arg(rotation)
                                 .arg(sum.seen);
        qInfo("%s", qPrintable(told));
        QVERIFY2(sum.seen >= 30, qPrintable(told));
        for (const double ratio : {across, along, rotation})
            QVERIFY2(std::abs(ratio - 1.0) < kSecondOrder, qPrintable(told));
    }

    void statesNoLessErrorThanThereIs_data()
    {
        QTest::addColumn<QString>("tool");
        QTest::addColumn<double>("distance");
        QTest::newRow("chest at 0.4 m") << QStringLiteral("Manikin") << 0.4;
        QTest::newRow("chest at 0.8 m") << QStringLiteral("Manikin") << 0.8;
        QTest::newRow("tube at 0.3 m") << QStringLiteral("Tube") << 0.3;
        QTest::newRow("tube at 0.5 m") << QStringLiteral("Tube") << 0.5;
    }

    /// The squares of the errors over the stated covariances are chi-squared, six degrees of
    /// freedom a pose, where these are right. Rendered corners are better than assumed: of the
    /// sheet, all of whose 16 corners are seen, it is known by how much that makes the squares
    /// less.
    void statesNoLessErrorThanThereIs()
    {
        QFETCH(QString, tool);
        QFETCH(double, distance);
        const MarkerAccuracy found = accuracyOf(tool.toStdString(), distance);
        const int poses = found.seen - found.wrong;
        QVERIFY(poses >= kPosesStated / 2);
        const double most = vision_test::rareShare(6.0 * poses);
        const double expected = vision_test::expectedSquare(found.cornerRms, 2 * 16 - 6);
        const QString told = QStringLiteral("%1; at most %2, for independent corners %3; corners "
                                            "off by %4 pixels; %5 poses")
                                 .arg(found.normalisedSquare)
                                 .arg(most)
                                 .arg(expected)
                                 .arg(found.cornerRms)
                                 .arg(poses);
        qInfo("%s", qPrintable(told));
        QVERIFY2(found.normalisedSquare < most, qPrintable(told));
        if (tool != QLatin1StringView{"Manikin"})
            return;
        QVERIFY2(found.normalisedSquare < most * expected, qPrintable(told));
        QVERIFY2(found.normalisedSquare > expected / kSharedEdges, qPrintable(told));
    }

    /// No pose that is given is its mirror image, however small the marker; the others are told to
    /// be ambiguous.
    void givesNoMirrorImage()
    {
        const MarkerAccuracy found = markerAccuracy({.camera = vision_test::webcam(),
                                                     .dictionary = kPrintedDictionary,
                                                     .body = {{0, 0.03, {}}},
                                                     .rendering = {},
                                                     .distance = 0.7,
                                                     .poses = 60});
        QCOMPARE(found.wrong, 0);
        QVERIFY(found.ambiguous > 0);
    }

    void growsWithTheDistance()
    {
        const MarkerAccuracy near = accuracyOf("Manikin", 0.4);
        const MarkerAccuracy far = accuracyOf("Manikin", 1.0);
        QVERIFY(near.alongRms < far.alongRms);
        QVERIFY(near.rotationRms < far.rotationRms);
    }
};

CARINA_TEST(TestMarkerAccuracy)

} // namespace carina::marker_accuracy_test

#include "tst_marker_accuracy.moc"
