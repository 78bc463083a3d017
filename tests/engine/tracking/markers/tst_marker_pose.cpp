#include "engine/tracking/markers/marker_search.h"

#include "engine/tracking/simulated/simulated_tracker.h"
#include "tests/engine/geometry/fit/registration_trials.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <array>
#include <limits>

namespace carina::marker_pose_test
{
namespace
{

constexpr double kExact = 1e-9; // metres and radians
constexpr Length kNoise = millimetres(0.1);
constexpr double kWithin = 1.0e-3; // metres, of a point 100 mm off, with that noise

/// A tool without symmetry, all of whose markers are seen from everywhere.
Probe tool(bool isFlat = false)
{
    const double up = isFlat ? 0.0 : 1.0;
    return {.markers = {{{0.0, 0.0, up * 0.011}},
                        {{0.050, 0.0, 0.0}},
                        {{-0.010, 0.085, up * 0.004}},
                        {{-0.042, -0.047, up * -0.017}},
                        {{0.032, -0.061, up * 0.023}}}};
}

struct Scene {
    RigidTransform X_TO;
    std::vector<SeenMarker> seen{};

    [[nodiscard]] std::vector<Vec3> points() const
    {
        std::vector<Vec3> points;
        for (const SeenMarker& marker : seen)
            points.push_back(marker.p_TQ);
        return points;
    }
};

/// A tool before the tracker, in any orientation.
Scene sceneOf(const Probe& probe, test::Hand& hand, Length noise = {})
{
    Scene scene{.X_TO = {hand.pose().rotation(), Vec3{0.1, -0.2, -1.1}}};
    for (std::size_t i = 0; i < probe.markers.size(); ++i)
        scene.seen.push_back(
            {.marker = i,
             .p_TQ = scene.X_TO * probe.markers[i].p_OQ + noise.si / std::sqrt(3.0) * hand.unit()});
    return scene;
}

/// A tool of markers drawn at random, its corners some 80 mm apart.
Probe randomTool(std::size_t count, test::Hand& hand)
{
    Probe probe;
    for (std::size_t i = 0; i < count; ++i)
        probe.markers.push_back({0.04 * hand.unit()});
    return probe;
}

std::vector<Vec3> places(const Probe& probe)
{
    std::vector<Vec3> places;
    for (const ToolMarker& marker : probe.markers)
        places.push_back(marker.p_OQ);
    return places;
}

/// How far points are from where the best pose, by Horn's method, puts those of the tool: RMS and
/// largest, metres.
struct HornMisfit {
    double rms = 0.0;
    double most = 0.0;
};

HornMisfit misfitByHorn(const std::vector<Vec3>& p_T, const std::vector<Vec3>& p_O)
{
    const RigidTransform X_TO = test::hornFit(p_T, p_O);
    HornMisfit misfit;
    for (std::size_t i = 0; i < p_T.size(); ++i) {
        const double d = (p_T[i] - X_TO * p_O[i]).norm();
        misfit.rms += d * d / double(p_T.size());
        misfit.most = std::max(misfit.most, d);
    }
    misfit.rms = std::sqrt(misfit.rms);
    return misfit;
}

/// How far the mirror image of those four markers is from them (RMS, laid over them as well as it
/// goes) of which it is nearest, metres: 0 where four are in one plane. Above the misfit allowed,
/// no pose puts four markers of the image at places that are allowed.
double leastMirrorMisfit(const Probe& probe)
{
    const std::vector<Vec3> all = places(probe);
    std::vector<bool> isChosen(all.size(), false);
    std::fill(isChosen.end() - 4, isChosen.end(), true);
    double least = std::numeric_limits<double>::infinity();
    do {
        std::vector<Vec3> four;
        std::vector<Vec3> image;
        for (std::size_t i = 0; i < all.size(); ++i)
            if (isChosen[i]) {
                four.push_back(all[i]);
                image.push_back({-all[i].x(), all[i].y(), all[i].z()});
            }
        least = std::min(least, misfitByHorn(image, four).rms);
    } while (std::next_permutation(isChosen.begin(), isChosen.end()));
    return least;
}

double off(const RigidTransform& a, const RigidTransform& b)
{
    const Vec3 far{0.06, 0.06, 0.05};
    return std::max((a * far - b * far).norm(), (a.translation() - b.translation()).norm());
}

std::vector<std::size_t> indices(const std::vector<SeenMarker>& markers)
{
    std::vector<std::size_t> all;
    for (const SeenMarker& marker : markers)
        all.push_back(marker.marker);
    return all;
}

} // namespace

class TestMarkerPose : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void recoversThePoseFromThreeMarkersOrMore_data()
    {
        QTest::addColumn<int>("count");
        for (const int count : {3, 4, 5})
            QTest::addRow("%d", count) << count;
    }

    void recoversThePoseFromThreeMarkersOrMore()
    {
        QFETCH(int, count);
        test::Hand hand{3};
        for (int trial = 0; trial < 50; ++trial) {
            Scene scene = sceneOf(tool(), hand);
            scene.seen.resize(std::size_t(count));
            const auto pose = markerPose(tool(), scene.seen);
            QVERIFY(pose.has_value());
            QVERIFY(off(pose->X_TO, scene.X_TO) < kExact);
            QVERIFY(pose->rms < kExact);
            QVERIFY(pose->leftOut.empty());
        }
    }

    void isThatOfHornsMethod()
    {
        test::Hand hand{4};
        for (int trial = 0; trial < 50; ++trial) {
            const Scene scene = sceneOf(tool(), hand, kNoise);
            std::vector<Vec3> p_O;
            for (const ToolMarker& marker : tool().markers)
                p_O.push_back(marker.p_OQ);
            QVERIFY(off(markerPose(tool(), scene.seen)->X_TO, test::hornFit(scene.points(), p_O))
                    < kExact);
        }
    }

    void leavesOutAMarkerThatIsElsewhere_data()
    {
        QTest::addColumn<int>("wrong");
        for (int i = 0; i < 5; ++i)
            QTest::addRow("marker %d", i) << i;
    }

    void leavesOutAMarkerThatIsElsewhere()
    {
        QFETCH(int, wrong);
        test::Hand hand{5};
        for (int trial = 0; trial < 50; ++trial) {
            Scene scene = sceneOf(tool(), hand, kNoise);
            scene.seen[std::size_t(wrong)].p_TQ += 0.015 * hand.unit().normalized();
            const auto pose = markerPose(tool(), scene.seen);
            QVERIFY(pose.has_value());
            QCOMPARE(pose->leftOut, std::vector{std::size_t(wrong)});
            QVERIFY(off(pose->X_TO, scene.X_TO) < kWithin);
        }
    }

    void leavesNoneOutOfFour()
    {
        test::Hand hand{12};
        for (int trial = 0; trial < 50; ++trial) {
            Scene scene = sceneOf(tool(), hand, kNoise);
            scene.seen.resize(4);
            scene.seen[std::size_t(trial) % 4].p_TQ += 0.015 * hand.unit().normalized();
            const auto pose = markerPose(tool(), scene.seen);
            // Moved along its circle about the other three it may still fit.
            QVERIFY(!pose.has_value() || pose->leftOut.empty());
        }
    }

    void refusesTheMirrorImage_data()
    {
        QTest::addColumn<int>("count");
        QTest::addColumn<bool>("isOneElsewhere");
        for (const int count : {4, 5, 6}) {
            QTest::addRow("%d markers", count) << count << false;
            QTest::addRow("%d markers, one elsewhere", count) << count << true;
        }
    }

    /// Of no tool but those of which four markers are nearly in one plane: these cannot be told
    /// from their image.
    void refusesTheMirrorImage()
    {
        QFETCH(int, count);
        QFETCH(bool, isOneElsewhere);
        constexpr int kTools = 500;
        const auto wrong = std::size_t(count - 1);
        test::Hand hand{6};
        int tools = 0;
        while (tools < kTools) {
            const Probe probe = randomTool(std::size_t(count), hand);
            const double allowed = probe.largestMisfit.si;
            if (leastMirrorMisfit(probe) <= 1.5 * allowed)
                continue;
            Scene scene = sceneOf(probe, hand, kNoise);
            for (SeenMarker& marker : scene.seen)
                marker.p_TQ.x() = -marker.p_TQ.x();
            if (isOneElsewhere) {
                scene.seen[wrong].p_TQ += 0.03 * hand.unit();
                // One of four that came to where the tool itself has it makes it the tool.
                if (misfitByHorn(scene.points(), places(probe)).most <= allowed)
                    continue;
            }
            ++tools;
            const auto pose = markerPose(probe, scene.seen);
            QVERIFY2(!pose.has_value(), qPrintable(QString::number(tools)));
            QCOMPARE(pose.error().code, Errc::DegenerateLandmarks);
        }
    }

    void takesTheSameToolsNotMirrored_data() { refusesTheMirrorImage_data(); }

    void takesTheSameToolsNotMirrored()
    {
        QFETCH(int, count);
        QFETCH(bool, isOneElsewhere);
        if (isOneElsewhere && count == 4)
            QSKIP("of four markers none is left out");
        constexpr int kTools = 500;
        constexpr double kElsewhere = 0.03; // metres
        const auto wrong = std::size_t(count - 1);
        test::Hand hand{6};
        int tools = 0;
        while (tools < kTools) {
            const Probe probe = randomTool(std::size_t(count), hand);
            if (leastMirrorMisfit(probe) <= 1.5 * probe.largestMisfit.si)
                continue;
            ++tools;
            Scene scene = sceneOf(probe, hand, kNoise);
            if (isOneElsewhere)
                scene.seen[wrong].p_TQ += kElsewhere * hand.unit().normalized();
            const auto pose = markerPose(probe, scene.seen);
            QVERIFY2(pose.has_value(), qPrintable(QString::number(tools)));
            QCOMPARE(pose->leftOut, std::vector<std::size_t>(isOneElsewhere ? 1 : 0, wrong));
        }
    }

    /// Its image is the tool turned over.
    void leavesAMarkerOutOfAFlatToolToo()
    {
        test::Hand hand{13};
        for (int trial = 0; trial < 50; ++trial) {
            Scene scene = sceneOf(tool(true), hand, kNoise);
            scene.seen[2].p_TQ += 0.015 * hand.unit().normalized();
            const auto pose = markerPose(tool(true), scene.seen);
            QVERIFY(pose.has_value());
            QCOMPARE(pose->leftOut, std::vector<std::size_t>{2});
            QVERIFY(off(pose->X_TO, scene.X_TO) < kWithin);
        }
    }

    void findsNoFourMarkersInTheMirrorImage()
    {
        test::Hand hand{6};
        Scene scene = sceneOf(tool(), hand);
        for (SeenMarker& marker : scene.seen)
            marker.p_TQ.x() = -marker.p_TQ.x();
        const auto found = searchMarkers(tool(), scene.points());
        QVERIFY(!found.has_value() || found->size() < 4);
    }

    void refusesWhatIsNotTheTool()
    {
        test::Hand hand{7};
        Scene scene = sceneOf(tool(), hand);
        QCOMPARE(markerPose(tool(), std::span{scene.seen}.first(2)).error().code,
                 Errc::TooFewLandmarks);
        for (SeenMarker& marker : scene.seen)
            marker.p_TQ += 0.02 * hand.unit();
        QCOMPARE(markerPose(tool(), scene.seen).error().code, Errc::DegenerateLandmarks);
    }

    void findsOutWhichMarkerIsWhichAmongOthers_data()
    {
        QTest::addColumn<int>("missing");
        QTest::addColumn<int>("strays");
        QTest::newRow("all, alone") << 0 << 0;
        QTest::newRow("all, six strays") << 0 << 6;
        QTest::newRow("one hidden, six strays") << 1 << 6;
        QTest::newRow("two hidden") << 2 << 0;
    }

    void findsOutWhichMarkerIsWhichAmongOthers()
    {
        QFETCH(int, missing);
        QFETCH(int, strays);
        test::Hand hand{8};
        for (int trial = 0; trial < 50; ++trial) {
            const Scene scene = sceneOf(tool(), hand, kNoise);
            std::vector<Vec3> points = scene.points();
            points.resize(points.size() - std::size_t(missing));
            for (int i = 0; i < strays; ++i)
                points.push_back(scene.X_TO.translation() + 0.15 * hand.unit());
            std::ranges::shuffle(points, hand.random());
            const auto found = searchMarkers(tool(), points);
            QVERIFY(found.has_value());
            QVERIFY(found->size() >= 5 - std::size_t(missing));
            const auto pose = markerPose(tool(), *found);
            QVERIFY(pose.has_value());
            QVERIFY(off(pose->X_TO, scene.X_TO) < 2.0 * kWithin);
        }
    }

    void refusesASymmetricTool()
    {
        Probe square{.markers = {{{0.04, 0.04, 0.0}, Vec3::UnitZ()},
                                 {{-0.04, 0.04, 0.0}, Vec3::UnitZ()},
                                 {{-0.04, -0.04, 0.0}, Vec3::UnitZ()},
                                 {{0.04, -0.04, 0.0}, Vec3::UnitZ()}}};
        const RigidTransform X_TO = RigidTransform::translation({0.0, 0.0, -1.0});
        std::vector<Vec3> points;
        for (const ToolMarker& marker : square.markers)
            points.push_back(X_TO * marker.p_OQ);
        QCOMPARE(searchMarkers(square, points).error().code, Errc::DegenerateLandmarks);
        QCOMPARE(searchMarkers(square, std::span{points}.first(2)).error().code,
                 Errc::TooFewLandmarks);
    }

    void doesNotTakeAFlatToolThatIsTurnedOver()
    {
        Probe flat = tool(true);
        for (ToolMarker& marker : flat.markers)
            marker.normal_O = Vec3::UnitZ();
        const RigidTransform ahead = RigidTransform::translation({0.0, 0.0, -1.0});
        std::vector<Vec3> points;
        for (const ToolMarker& marker : flat.markers)
            points.push_back(ahead * marker.p_OQ);
        QCOMPARE(searchMarkers(flat, points)->size(), std::size_t{5});
        for (Vec3& point : points)
            point.x() = -point.x(); // the mirror image, as the tool seen from behind
        QVERIFY(!searchMarkers(flat, points).has_value());
    }

    void knowsTheProbesOfTheSimulatedTracker_data()
    {
        QTest::addColumn<int>("role");
        for (int role = 0; role <= int(ToolRole::Laryngoscope); ++role)
            QTest::addRow("role %d", role) << role;
    }

    /// From any side, without a known order.
    void knowsTheProbesOfTheSimulatedTracker()
    {
        QFETCH(int, role);
        const Probe probe = simulatedProbe(ToolRole(role));
        test::Hand hand{9};
        for (int trial = 0; trial < 100; ++trial) {
            const Scene scene = sceneOf(probe, hand, kNoise);
            const Vec3 d_O =
                scene.X_TO.rotation().conjugate() * -scene.X_TO.translation().normalized();
            std::vector<Vec3> points;
            for (const std::size_t i : facingMarkers(probe, d_O))
                points.push_back(scene.seen[i].p_TQ);
            const auto found = searchMarkers(probe, points);
            QVERIFY2(found.has_value(), found ? "" : found.error().detail.c_str());
            QVERIFY(found->size() + 1 >= points.size());
            for (const std::size_t i : indices(*found))
                QVERIFY(std::ranges::count(points, scene.seen[i].p_TQ) == 1);
        }
    }
};

CARINA_TEST(TestMarkerPose)

} // namespace carina::marker_pose_test

#include "tst_marker_pose.moc"
