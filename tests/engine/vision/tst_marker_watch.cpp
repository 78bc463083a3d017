#include "engine/geometry/rotation.h"
#include "engine/vision/marker_watch.h"
#include "evaluation/vision/marker_renderer.h"
#include "tests/engine/vision/vision_bench.h"
#include "tests/support/test_class.h"

namespace carina::marker_watch_test
{
namespace
{

constexpr double kLengthTolerance = 2e-3;           ///< metres
constexpr double kAngleTolerance = degrees(2.0).si; ///< radians
constexpr double kCornerTolerance = 0.15;           ///< pixels
constexpr Duration kFrame = std::chrono::milliseconds{33};

const MarkerBody kSmall{{20, 0.02, {}}};

GreyPicture rendered(std::vector<PosedBody> bodies)
{
    MarkerRenderer renderer{vision_test::webcam(), kPrintedDictionary, {}};
    return renderer.draw(bodies);
}

/// What an exact camera sees of a marker.
DetectedMarker exactly(const BodyMarker& marker, const RigidTransform& X_TB)
{
    DetectedMarker seen{marker.id, {}};
    const auto p_BQ = cornersOf(marker);
    for (std::size_t i = 0; i < 4; ++i)
        seen.corners[i] = *project(vision_test::webcam(), X_TB * p_BQ[i]);
    return seen;
}

MarkerWatch watchOf(MarkerBody body)
{
    return MarkerWatch{{vision_test::webcam(), kPrintedDictionary, {std::move(body)}}};
}

bool isNear(const BodySight& sight, const RigidTransform& X_TB)
{
    return sight.pose
           && (sight.pose->X_TB.translation() - X_TB.translation()).norm() < kLengthTolerance
           && angleBetween(sight.pose->X_TB.rotation(), X_TB.rotation()).si < kAngleTolerance;
}

} // namespace

class TestMarkerWatch : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void findsCornersToAFractionOfAPixel()
    {
        const MarkerBody& body = vision_test::printed("Manikin").body;
        const RigidTransform X_TB = vision_test::facing({0.03, 0.02, -0.55}, 25.0, 40.0, 15.0);
        const auto seen = seenMarkers(rendered({{&body, X_TB}}), kPrintedDictionary);
        QCOMPARE(seen.size(), body.size());
        for (const DetectedMarker& marker : seen) {
            const auto of = std::ranges::find(body, marker.id, &BodyMarker::id);
            const DetectedMarker truth = exactly(*of, X_TB);
            for (std::size_t i = 0; i < 4; ++i)
                QVERIFY((marker.corners[i] - truth.corners[i]).norm() < kCornerTolerance);
        }
    }

    void findsEveryPrintedTool()
    {
        std::vector<PosedBody> placed;
        WatchedBodies watched{vision_test::webcam(), kPrintedDictionary, {}};
        const std::vector<PrintedTool>& tools = printedTools();
        for (std::size_t i = 0; i < tools.size(); ++i) {
            const Vec3 p_T{-0.2 + 0.1 * double(i), i % 2 == 0 ? 0.06 : -0.1, -0.55};
            placed.push_back(
                {&tools[i].body,
                 vision_test::facing(p_T, tools[i].isSleeve ? 80.0 : 30.0, 10.0, 40.0)});
            watched.bodies.push_back(tools[i].body);
        }
        MarkerWatch watch{watched};
        const auto sights = watch.look(rendered(placed), {});
        for (std::size_t i = 0; i < tools.size(); ++i)
            QVERIFY2(isNear(sights[i], placed[i].X_TB), tools[i].name.c_str());
    }

    void seesNothingInAnEmptyPicture()
    {
        const auto sights = watchOf(kSmall).look(rendered({}), {});
        QCOMPARE(sights[0].markers, 0);
        QVERIFY(!sights[0].pose);
        QVERIFY(!sampleOf(sights[0], 560.0, SessionTime{}));
    }

    /// A small marker far away, nearly straight on: the two poses differ by a hundredth of a pixel.
    void saysThatASmallFlatMarkerIsAmbiguous()
    {
        const RigidTransform X_TB = vision_test::facing({0.0, 0.0, -1.2}, 20.0);
        const auto sights = watchOf(kSmall).look({exactly(kSmall[0], X_TB)}, {});
        QVERIFY(sights[0].pose);
        QVERIFY(sights[0].isAmbiguous);
        QVERIFY(!sampleOf(sights[0], 560.0, SessionTime{}));
    }

    /// Moved away from where it was sure, for less than it remembers, and with corners that favour
    /// the mirror image.
    void keepsToTheSideThatItWasSureOf()
    {
        MarkerWatch watch = watchOf(kSmall);
        Duration time{};
        for (double away = 0.15; away < 1.1; away += 0.15, time += kFrame) {
            const RigidTransform X_TB = vision_test::facing({0.0, 0.0, -away}, 25.0);
            DetectedMarker seen = exactly(kSmall[0], X_TB);
            if (away > 0.8) { // as if it were tilted to the other side
                const DetectedMarker mirrored =
                    exactly(kSmall[0], vision_test::facing({0.0, 0.0, -away}, -25.0));
                for (std::size_t i = 0; i < 4; ++i)
                    seen.corners[i] = 0.3 * seen.corners[i] + 0.7 * mirrored.corners[i];
            }
            const auto sights = watch.look({seen}, time);
            QVERIFY(sights[0].pose && !sights[0].isAmbiguous);
            QVERIFY(angleBetween(sights[0].pose->X_TB.rotation(), X_TB.rotation()) < degrees(15.0));
        }
    }

    /// Each pose continues the one before, but none of them is sure.
    void doesNotGoOnGuessingFromGuesses()
    {
        MarkerWatch watch = watchOf(kSmall);
        const auto isAmbiguousAt = [&](double away, Duration time) {
            const RigidTransform X_TB = vision_test::facing({0.0, 0.0, -away}, 25.0);
            return watch.look({exactly(kSmall[0], X_TB)}, time)[0].isAmbiguous;
        };
        QVERIFY(!isAmbiguousAt(0.15, {}));
        for (Duration time = kFrame; time < 4 * MarkerWatch::kMemory; time += kFrame)
            QCOMPARE(isAmbiguousAt(1.2, time), time > MarkerWatch::kMemory);
    }

    void forgetsTheSideAfterAWhile()
    {
        MarkerWatch watch = watchOf(kSmall);
        QVERIFY(
            !watch.look({exactly(kSmall[0], vision_test::facing({0.0, 0.0, -0.15}, 25.0))}, {})[0]
                 .isAmbiguous);
        const auto later =
            watch.look({exactly(kSmall[0], vision_test::facing({0.0, 0.0, -1.2}, 25.0))},
                       MarkerWatch::kMemory + kFrame);
        QVERIFY(later[0].isAmbiguous);
    }

    /// A second sheet with the same marker: nobody knows which is the tool.
    void usesNoMarkerThatIsThereTwice()
    {
        const DetectedMarker here = exactly(kSmall[0], vision_test::facing({0.0, 0.0, -0.3}, 25.0));
        const DetectedMarker there =
            exactly(kSmall[0], vision_test::facing({0.1, 0.0, -0.3}, 25.0));
        const auto sights = watchOf(kSmall).look({here, there}, {});
        QCOMPARE(sights[0].markers, 0);
        QVERIFY(!sights[0].pose);
    }

    /// Markers that were glued on otherwise than the file says.
    void givesNoPoseThatDoesNotFit()
    {
        MarkerBody body = vision_test::printed("Manikin").body;
        const RigidTransform X_TB = vision_test::facing({0.0, 0.0, -0.4}, 25.0);
        std::vector<DetectedMarker> seen;
        for (const BodyMarker& marker : body)
            seen.push_back(exactly(marker, X_TB));
        QVERIFY(watchOf(body).look(seen, {})[0].pose);
        std::swap(body[0].X_BK, body[2].X_BK);
        QVERIFY(!watchOf(body).look(seen, {})[0].pose);
    }

    void boundsTheMisfitByTheSizeInThePicture_data()
    {
        QTest::addColumn<double>("distance");
        QTest::addColumn<double>("share");
        QTest::addColumn<bool>("isBody");
        QTest::newRow("paper that is not flat, near") << 0.15 << 0.025 << true;
        QTest::newRow("the same far away") << 0.8 << 0.025 << true;
        QTest::newRow("something else, near") << 0.15 << 0.12 << false;
        QTest::newRow("something else, far away") << 0.8 << 0.12 << false;
    }

    /// By a share of a marker's side, of every other corner.
    void boundsTheMisfitByTheSizeInThePicture()
    {
        QFETCH(const double, distance);
        QFETCH(const double, share);
        QFETCH(const bool, isBody);
        const MarkerBody& body = vision_test::printed("Manikin").body;
        const RigidTransform X_TB = vision_test::facing({0.0, 0.0, -distance}, 25.0);
        std::vector<DetectedMarker> seen;
        for (const BodyMarker& marker : body) {
            seen.push_back(exactly(marker, X_TB));
            auto& corners = seen.back().corners;
            const double off = share * (corners[1] - corners[0]).norm();
            for (std::size_t i = 0; i < 4; ++i)
                corners[i].x() += i % 2 == 0 ? off : -off;
        }
        QCOMPARE(watchOf(body).look(seen, {})[0].pose.has_value(), isBody);
    }

    void statesTheFitErrorInMetres()
    {
        const MarkerBody& body = vision_test::printed("Manikin").body;
        const RigidTransform X_TB = vision_test::facing({0.0, 0.0, -0.5}, 25.0);
        std::vector<DetectedMarker> seen;
        for (const BodyMarker& marker : body)
            seen.push_back(exactly(marker, X_TB));
        const double off[]{0.4, -0.4}; // pixels, of every other corner
        for (DetectedMarker& marker : seen)
            for (std::size_t i = 0; i < 4; ++i)
                marker.corners[i].x() += off[i % 2];
        const auto sight = watchOf(body).look(seen, {})[0];
        const auto sample = sampleOf(sight, 560.0, SessionTime{});
        QVERIFY(sample);
        QVERIFY(std::abs(sample->error
                         - sight.pose->rms * sight.pose->X_TB.translation().norm() / 560.0)
                < 1e-12);
        QVERIFY(sample->error > 0.2e-3 && sample->error < 0.4e-3); // 0.4 pixels at 0.5 m: 0.36 mm
        QCOMPARE(sample->validity, Validity::Tracked);
    }

    void saysThatAFarSmallToolIsSeenPoorly()
    {
        const MarkerBody& body = vision_test::printed("Tube").body;
        const RigidTransform X_TB = vision_test::facing({0.0, 0.0, -2.5}, 80.0, 0.0, 40.0);
        std::vector<DetectedMarker> seen{exactly(body[0], X_TB), exactly(body[1], X_TB)};
        const auto sight = watchOf(body).look(seen, {})[0];
        const auto sample = sampleOf(sight, 560.0, SessionTime{});
        if (sample)
            QCOMPARE(sample->validity, Validity::PartlyOccluded);
        else
            QVERIFY(sight.isAmbiguous);
    }

    /// The error of a point of the body is the same in whatever frame the covariance is told.
    void tellsTheCovarianceInTheBody()
    {
        FittedBody pose{.X_TB = {rotationFromVector({0.4, -1.1, 0.3}), {0.1, -0.2, -0.7}}};
        Mat6 half = Mat6::Zero();
        for (int i = 0; i < 36; ++i)
            half(i / 6, i % 6) = std::sin(1.0 + 2.3 * i);
        pose.covariance_T = half * half.transpose();
        const Mat3 R_TB = pose.X_TB.rotation().toRotationMatrix();
        for (const Vec3& p_BQ : {Vec3{0.0, 0.0, 0.0}, Vec3{0.03, -0.2, 0.1}}) {
            const Mat3 in_T = pointCovariance(pose.covariance_T, pose.X_TB * p_BQ);
            const Mat3 in_B = pointCovariance(inBody(pose), p_BQ);
            QVERIFY((R_TB * in_B * R_TB.transpose() - in_T).norm() < 1e-9 * in_T.norm());
        }
        const auto sample = sampleOf({.markers = 1, .pose = pose}, 500.0, SessionTime{});
        QVERIFY(sample->covariance_O == inBody(pose));
    }
};

CARINA_TEST(TestMarkerWatch)

} // namespace carina::marker_watch_test

#include "tst_marker_watch.moc"
