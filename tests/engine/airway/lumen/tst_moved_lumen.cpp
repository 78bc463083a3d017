#include "engine/airway/lumen/moved_lumen.h"
#include "tests/support/test_class.h"

#include <cmath>

namespace carina::moved_lumen_test
{
namespace
{

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
    return roundLumen(lines, radii, metres(kTube));
}

double depthAt(const MovedLumen& lumen, const Vec3& p_A)
{
    std::size_t segment = lumen.way(AirwayWay::Trunk).nearestSegment(p_A);
    return lumen.touchIn(AirwayWay::Trunk, 1.0, p_A, segment).depth;
}

} // namespace

class TestMovedLumen : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void hasItsWallWhereATubeTouchesIt();
    void leavesNoStraightWallBehind();
    void hasTheGradientOfItsDepth();
    void hasTheCurvatureOfItsWall();
    void goesOnBetweenItsSections();
    void followsAShift();
    void isWidenedByAPushAndNotNarrowed();
    void narrowsAsWallsComeTogether();
    void isStoppedWhereItIsTooNarrow();
    void endsAtItsEnd();
    void isFreeInFrontOfTheMouth();
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

void TestMovedLumen::leavesNoStraightWallBehind()
{
    // Between two plates 32 mm apart: at a plate no place is inside that is beyond it by more.
    constexpr double kOutside = 0.2e-3; // metres
    constexpr double kPlate = 0.016;
    constexpr double kWide = 0.05;
    AirwayLumen lumen = pipe();
    for (LumenSection& section : lumen.ways.front())
        for (LumenLimit& limit : section.limits) {
            const Vec3 out = -limit.fromWall.normalized();
            const double reach = std::min(kPlate / std::max(std::abs(out.x()), 1e-9), kWide);
            limit.p_A_wall = section.p_A_centre + reach * out - limit.fromWall;
        }
    const MovedLumen plates = unmoved(lumen);
    for (int i = -100; i <= 100; ++i) {
        const double y = 0.0003 * i;
        QVERIFY(depthAt(plates, {kPlate + kOutside, y, -0.05}) > 0.0);
        QVERIFY(depthAt(plates, {-kPlate - kOutside, y, -0.05}) > 0.0);
    }
}

void TestMovedLumen::hasTheGradientOfItsDepth()
{
    constexpr double kStep = 1e-7;
    constexpr double kSlope = 1e-4;
    AirwayLumen lumen = pipe();
    // A section that is neither round nor like its neighbours, but as wide to both sides.
    for (std::size_t k = 0; k < kLumenDirections; ++k)
        lumen.ways.front()[10].limits[k].fromWall *= 0.7 + 0.1 * double(k % 4);
    const MovedLumen moved = unmoved(lumen);
    for (int i = 0; i < 30; ++i) {
        const Vec3 p{0.008 * std::cos(0.37 * i), 0.008 * std::sin(0.37 * i), -0.0385};
        std::size_t segment = 9;
        const WallTouch touch = moved.touchIn(AirwayWay::Trunk, 1.0, p, segment);
        for (int axis = 0; axis < 3; ++axis) {
            Vec3 step = Vec3::Zero();
            step[axis] = kStep;
            const double slope =
                (depthAt(moved, p + step) - depthAt(moved, p - step)) / (2 * kStep);
            QVERIFY(std::abs(slope - touch.out[axis]) < kSlope);
        }
    }
}

void TestMovedLumen::hasTheCurvatureOfItsWall()
{
    // round * round^T is the second derivative along the wall of a pipe: 1 / r.
    const MovedLumen lumen = unmoved(pipe());
    for (int i = 0; i < 32; ++i) {
        const double r = 0.007;
        const Vec3 out{std::cos(0.2 * i), std::sin(0.2 * i), 0.0};
        std::size_t segment = 12;
        const WallTouch touch =
            lumen.touchIn(AirwayWay::Trunk, 1.0, Vec3{0.0, 0.0, -0.05} + r * out, segment);
        QVERIFY(touch.depth > 0.0);
        QVERIFY(std::abs(touch.round.squaredNorm() * r - 1.0) < 1e-6);
        QVERIFY(std::abs(touch.round.dot(out)) < 1e-6);
    }
}

void TestMovedLumen::goesOnBetweenItsSections()
{
    // A piece of the wall is that of the way where it was taken, and up to both sections.
    AirwayLumen lumen = pipe();
    for (LumenLimit& limit : lumen.ways.front()[10].limits)
        limit.fromWall *= 1.5;
    const MovedLumen narrow = unmoved(lumen);
    const double along = 0.0385;
    const MovedPiece piece = narrow.pieceAt(AirwayWay::Trunk, 9, along);
    for (const double z : {-0.0361, -0.038, -0.0399}) {
        const Vec3 p{0.005, 0.002, z};
        QVERIFY(std::abs(piece.touch(p).depth - depthAt(narrow, p)) < kSame);
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

void TestMovedLumen::endsAtItsEnd()
{
    const MovedLumen lumen = unmoved(pipe());
    std::size_t segment = 20;
    const WallTouch touch = lumen.touchIn(AirwayWay::Trunk, 0.1, {0.0, 0.0, -0.103}, segment);
    QVERIFY(std::abs(touch.depth - 0.003) < kSame);
    QVERIFY((touch.out + Vec3::UnitZ()).norm() < kSame);
    segment = 20;
    QVERIFY(
        std::abs(lumen.touchIn(AirwayWay::Trunk, 0.05, {0.0, 0.0, -0.052}, segment).depth - 0.002)
        < kSame);
}

void TestMovedLumen::isFreeInFrontOfTheMouth()
{
    QVERIFY(depthAt(unmoved(pipe()), {0.2, 0.0, 0.001}) < 0.0);
}

CARINA_TEST(TestMovedLumen)

} // namespace carina::moved_lumen_test

#include "tst_moved_lumen.moc"
