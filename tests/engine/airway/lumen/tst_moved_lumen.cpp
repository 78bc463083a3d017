#include "engine/airway/lumen/moved_lumen.h"
#include "tests/engine/airway/lumen/still_lumen.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace carina::moved_lumen_test
{
namespace
{

using test::unmoved;

constexpr double kSame = 1e-9;   // metres
constexpr double kTube = 0.004;  // metres
constexpr double kRadius = 0.01; // of the lumen, metres
constexpr double kPush = 0.005;  // metres

/// Straight down, 10 cm.
AirwayLumen pipe()
{
    std::array<std::vector<Vec3>, kAirwayWays> lines;
    std::array<std::vector<double>, kAirwayWays> radii;
    for (int i = 0; i <= 25; ++i) {
        lines.front().emplace_back(0.0, 0.0, -0.004 * i);
        radii.front().push_back(kRadius);
    }
    return test::roundLumen(lines, radii, metres(kTube));
}

/// Beyond the farthest of the sides of the section in which a place lies, metres.
double depthAt(const MovedLumen& lumen, const Vec3& p_A)
{
    const MovedWay& trunk = lumen.way(AirwayWay::Trunk);
    std::size_t segment = trunk.nearestSegment(p_A);
    const MovedSection section = lumen.sectionAt(AirwayWay::Trunk, trunk.alongAt(p_A, segment));
    double depth = -1.0;
    for (std::size_t k = 0; k < kLumenDirections; ++k) {
        const double angle = 2.0 * std::numbers::pi * double(k) / kLumenDirections;
        const Vec3 out = std::cos(angle) * section.side + std::sin(angle) * section.back;
        depth = std::max(depth, out.dot(p_A - section.p_A_centre) - section.reach[k]);
    }
    return depth;
}

} // namespace

class TestMovedLumen : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void hasItsWallWhereATubeTouchesIt();
    void followsAShift();
    void isWidenedByAPushAndNotNarrowed();
    void narrowsAsWallsComeTogether();
    void isStoppedWhereItIsTooNarrow();
    void knowsHowFarAPlaceIsFromItsMiddles();
};

void TestMovedLumen::hasItsWallWhereATubeTouchesIt()
{
    constexpr double kOfRadius = 0.05; // the section is round to so much
    const MovedLumen lumen = unmoved(pipe());
    for (int i = 0; i < 32; ++i) {
        const double angle = 0.2 * i;
        const Vec3 out{std::cos(angle), std::sin(angle), 0.0};
        const double room = kRadius - kTube;
        const Vec3 middle{0.0, 0.0, -0.05};
        QVERIFY(depthAt(lumen, middle + (1.0 - kOfRadius) * room * out) < 0.0);
        QVERIFY(depthAt(lumen, middle + (1.0 + kOfRadius) * room * out) > 0.0);
    }
}

void TestMovedLumen::followsAShift()
{
    const AirwayLumen still = pipe();
    const Vec3 shift{0.003, -0.002, 0.001};
    const MovedLumen before = unmoved(still);
    const MovedLumen after =
        moved(still, [&](const Vec3& p_A, AirwayTissue /*tissue*/) -> Vec3 { return p_A + shift; });
    for (int i = 0; i < 20; ++i) {
        const Vec3 p{0.001 * i, 0.0005 * i, -0.003 * i - 0.01};
        QVERIFY(std::abs(depthAt(before, p) - depthAt(after, p + shift)) < kSame);
    }
}

void TestMovedLumen::isWidenedByAPushAndNotNarrowed()
{
    // A blade that takes all around a pipe to one side gives room there, and leaves the other side.
    constexpr double kNear = 3e-4; // metres: the section is round to so much
    const auto still = [](const Vec3& p_A, AirwayTissue /*tissue*/) { return p_A; };
    const MovedLumen wide = moved(pipe(), still, [](const Vec3& p_A, AirwayTissue /*tissue*/) {
        return Vec3{p_A + kPush * Vec3::UnitX()};
    });
    const double room = kRadius - kTube;
    QVERIFY(std::abs(depthAt(wide, {room + kPush, 0.0, -0.05})) < kNear);
    QVERIFY(std::abs(depthAt(wide, {-room, 0.0, -0.05})) < kNear);
    QVERIFY(wide.way(AirwayWay::Trunk).sections[12].p_A_centre.norm() < 0.048 + kSame);
}

void TestMovedLumen::narrowsAsWallsComeTogether()
{
    // Each side by 4 mm towards the midplane: 2 mm are left on each for the middle of the tube.
    const MovedLumen narrow = moved(pipe(), [](const Vec3& p_A, AirwayTissue /*tissue*/) {
        return Vec3{p_A.x() - std::copysign(std::min(std::abs(p_A.x()), 0.004), p_A.x()), p_A.y(),
                    p_A.z()};
    });
    QVERIFY(std::abs(narrow.way(AirwayWay::Trunk).sections[5].spare - 0.002) < kSame);
    QVERIFY(depthAt(narrow, {0.0025, 0.0, -0.05}) > 0.0);
    QVERIFY(depthAt(narrow, {0.0, 0.005, -0.05}) < 0.0);
}

void TestMovedLumen::isStoppedWhereItIsTooNarrow()
{
    AirwayLumen lumen = pipe();
    for (LumenLimit& limit : lumen.ways.front()[12].limits)
        limit.p_A_wall =
            lumen.ways.front()[12].p_A_centre
            + (0.0035 / kRadius) * (limit.p_A_wall - lumen.ways.front()[12].p_A_centre);
    const MovedLumen narrow = unmoved(lumen);
    const double stop = narrow.way(AirwayWay::Trunk).stopBehind(0.0);
    QVERIFY(stop > 0.044 && stop < 0.048);
    QVERIFY(std::abs(narrow.way(AirwayWay::Trunk).stopBehind(0.05) - 0.1) < kSame);
    // Tissue that gives way lets it pass.
    lumen.ways.front()[12].give = millimetres(1.0);
    QVERIFY(std::abs(unmoved(lumen).way(AirwayWay::Trunk).stopBehind(0.0) - 0.1) < kSame);
}

void TestMovedLumen::knowsHowFarAPlaceIsFromItsMiddles()
{
    const MovedLumen lumen = unmoved(pipe());
    const MovedWay& trunk = lumen.way(AirwayWay::Trunk);
    QVERIFY(std::abs(trunk.fromMiddles({0.003, 0.004, -0.0501}) - 0.005) < kSame);
    QVERIFY(std::abs(trunk.fromMiddles({0.0, 0.0, -0.107}) - 0.007) < kSame);
}

CARINA_TEST(TestMovedLumen)

} // namespace carina::moved_lumen_test

#include "tst_moved_lumen.moc"
