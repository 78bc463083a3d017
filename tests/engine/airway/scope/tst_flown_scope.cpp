#include "engine/airway/scope/flown_scope.h"
#include "tests/support/test_class.h"

#include <cmath>
#include <numbers>
#include <random>

namespace carina::flown_scope_test
{
namespace
{

constexpr double kTube = 0.01;  // radius of the lumen, metres
constexpr double kLength = 0.2; // metres
constexpr double kBall = 0.002; // radius of the camera, metres
constexpr double kOver = 1e-4;  // metres, by which it may be outside
constexpr double kFacets =
    2.5e-5; // metres: a circle of kSides sides is so much within the round one
constexpr std::uint32_t kSides = 48;

/// A lid across the tube at a height.
void addLid(TriangleMesh& mesh, double z)
{
    const auto first = std::uint32_t(mesh.positions.size());
    mesh.positions.emplace_back(0.0F, 0.0F, float(z));
    for (std::uint32_t k = 0; k < kSides; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / kSides;
        mesh.positions.emplace_back(float(kTube * std::cos(angle)), float(kTube * std::sin(angle)),
                                    float(z));
        mesh.triangles.push_back({first, first + 1 + k, first + 1 + (k + 1) % kSides});
    }
}

/// From 0 straight down, shut at both ends, in rings 5 mm apart.
TriangleMesh shutTube()
{
    constexpr std::uint32_t kRings = 41;
    TriangleMesh mesh;
    for (std::uint32_t ring = 0; ring < kRings; ++ring)
        for (std::uint32_t k = 0; k < kSides; ++k) {
            const double angle = 2.0 * std::numbers::pi * k / kSides;
            mesh.positions.emplace_back(float(kTube * std::cos(angle)),
                                        float(kTube * std::sin(angle)),
                                        float(-kLength * ring / (kRings - 1)));
        }
    for (std::uint32_t ring = 0; ring + 1 < kRings; ++ring)
        for (std::uint32_t k = 0; k < kSides; ++k) {
            const std::uint32_t a = ring * kSides + k;
            const std::uint32_t b = ring * kSides + (k + 1) % kSides;
            mesh.triangles.push_back({a, b, b + kSides});
            mesh.triangles.push_back({a, b + kSides, a + kSides});
        }
    addLid(mesh, 0.0);
    addLid(mesh, -kLength);
    return mesh;
}

ScopeWalls wallsOf(const TriangleMesh& mesh)
{
    const AnatomyPart part{
        .name = "Tube", .role = PartRole::Trachea, .conceptId = {}, .levels = {mesh}};
    std::vector<Vec3> line;
    for (int i = 0; i <= 20; ++i)
        line.emplace_back(0.0, 0.0, -0.01 * i);
    return {std::span{&part, 1}, line, millimetres(30.0)};
}

/// At a height, looking down. A camera looks along -z.
FlownScope scopeAt(double z)
{
    FlownScope scope{metres(kBall)};
    scope.place(RigidTransform::translation({0.0, 0.0, z}));
    return scope;
}

double besideAxis(const FlownScope& scope) { return scope.pose().translation().head<2>().norm(); }

} // namespace

class TestFlownScope : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void staysInsideWhateverIsAskedOfIt();
    void goesOnAlongAWall();
    void isStoppedByWhatItMeetsHeadOn();
    void passesNoThinWallByALongWay();
    void comesBackTheWayItWent();
    void looksToTheSideThatItIsTurnedTo();
    void goesAlongWithTheTissueAroundIt();
    void staysInsideOfWhatClosesAroundIt();
    void goesNoFartherThanItsLeash();
};

void TestFlownScope::staysInsideWhateverIsAskedOfIt()
{
    ScopeWalls walls = wallsOf(shutTube());
    FlownScope scope = scopeAt(-0.05);
    std::mt19937 random{7};
    const auto within = [&](double most) {
        return most * (2.0 * double(random()) / double(std::mt19937::max()) - 1.0);
    };
    double lowest = 0.0;
    for (int i = 0; i < 300; ++i) {
        scope.turn(degrees(within(60.0)), degrees(within(60.0)));
        scope.roll(degrees(within(90.0)));
        scope.advance(metres(within(0.08)), walls);
        const double z = scope.pose().translation().z();
        lowest = std::min(lowest, z);
        QVERIFY(besideAxis(scope) < kTube - kBall + kOver);
        QVERIFY(z < -kBall + kOver && z > -kLength + kBall - kOver);
    }
    QVERIFY(lowest < -0.5 * kLength); // it flew
}

void TestFlownScope::goesOnAlongAWall()
{
    constexpr double kWay = 0.1;    // metres
    constexpr double kNear = 0.002; // metres
    ScopeWalls walls = wallsOf(shutTube());
    FlownScope scope = scopeAt(-0.02);
    scope.turn(degrees(30.0), {});
    scope.advance(metres(kWay), walls);
    // Only the part of the way across the tube is taken from it.
    const double down = -0.02 - scope.pose().translation().z();
    QVERIFY(std::abs(down - kWay * std::cos(degrees(30.0).si)) < kNear);
    QVERIFY(scope.isAtWall(walls));
    QVERIFY(std::abs(besideAxis(scope) - (kTube - kBall)) < kOver + kFacets);
    QVERIFY(scope.pose().translation().x() > 0.0); // its right, as it looks down with +y up
}

void TestFlownScope::isStoppedByWhatItMeetsHeadOn()
{
    ScopeWalls walls = wallsOf(shutTube());
    FlownScope scope = scopeAt(-0.15);
    QVERIFY(!scope.isAtWall(walls));
    scope.advance(metres(0.04), walls);
    QVERIFY(std::abs(scope.pose().translation().z() + 0.19) < 1e-9);
    scope.advance(metres(0.04), walls);
    QVERIFY(std::abs(scope.pose().translation().z() + kLength - kBall) < kOver);
    QVERIFY(scope.isAtWall(walls));
}

void TestFlownScope::passesNoThinWallByALongWay()
{
    TriangleMesh mesh = shutTube();
    addLid(mesh, -0.1);
    ScopeWalls walls = wallsOf(mesh);
    for (const double way : {0.05, 1.0, 30.0}) {
        FlownScope scope = scopeAt(-0.06);
        scope.advance(metres(way), walls);
        QVERIFY(std::abs(scope.pose().translation().z() + 0.1 - kBall) < kOver);
    }
}

void TestFlownScope::comesBackTheWayItWent()
{
    ScopeWalls walls = wallsOf(shutTube());
    FlownScope scope = scopeAt(-0.05);
    scope.turn(degrees(3.0), degrees(-2.0));
    const Vec3 before = scope.pose().translation();
    scope.advance(metres(0.06), walls);
    QVERIFY((scope.pose().translation() - before).norm() > 0.059);
    scope.advance(metres(-0.06), walls);
    QVERIFY((scope.pose().translation() - before).norm() < 1e-9);
}

void TestFlownScope::looksToTheSideThatItIsTurnedTo()
{
    FlownScope scope = scopeAt(-0.05);
    const auto ahead = [&]() -> Vec3 { return scope.pose().rotation() * Vec3{0.0, 0.0, -1.0}; };
    scope.turn(degrees(90.0), {});
    QVERIFY((ahead() - Vec3::UnitX()).norm() < 1e-9);
    scope.turn({}, degrees(90.0));
    QVERIFY((ahead() - Vec3::UnitY()).norm() < 1e-9);
    const Vec3 up = scope.pose().rotation() * Vec3::UnitY();
    const Vec3 right = scope.pose().rotation() * Vec3::UnitX();
    scope.roll(degrees(90.0));
    QVERIFY((ahead() - Vec3::UnitY()).norm() < 1e-9);
    QVERIFY((scope.pose().rotation() * Vec3::UnitY() - right).norm() < 1e-9);
    QVERIFY((scope.pose().rotation() * Vec3::UnitX() + up).norm() < 1e-9);
}

void TestFlownScope::goesAlongWithTheTissueAroundIt()
{
    ScopeWalls walls = wallsOf(shutTube());
    walls.move([](const Vec3& p_A, AirwayTissue /*tissue*/) { return p_A; });
    FlownScope scope = scopeAt(-0.05);
    scope.follow(walls);
    const RigidTransform motion{Quat{Eigen::AngleAxisd{0.4, Vec3{1.0, 2.0, 0.5}.normalized()}},
                                {0.03, -0.02, 0.05}};
    const RigidTransform expected = motion * scope.pose();
    walls.move([&](const Vec3& p_A, AirwayTissue /*tissue*/) -> Vec3 { return motion * p_A; });
    scope.follow(walls);
    QVERIFY((scope.pose().matrix() - expected.matrix()).norm() < 1e-6);
    // And once it has arrived it stays.
    walls.move([&](const Vec3& p_A, AirwayTissue /*tissue*/) -> Vec3 { return motion * p_A; });
    scope.follow(walls);
    QVERIFY((scope.pose().matrix() - expected.matrix()).norm() < 1e-6);
}

void TestFlownScope::staysInsideOfWhatClosesAroundIt()
{
    ScopeWalls walls = wallsOf(shutTube());
    FlownScope scope = scopeAt(-0.05);
    scope.turn(degrees(90.0), {});
    scope.advance(metres(0.02), walls);
    scope.turn(degrees(-90.0), {});
    const auto narrowedTo = [&](double share) {
        walls.move([share](const Vec3& p_A, AirwayTissue /*tissue*/) {
            return Vec3{share * p_A.x(), share * p_A.y(), p_A.z()};
        });
        scope.follow(walls);
    };
    for (double share = 1.0; share > 0.1; share *= 0.97) {
        narrowedTo(share);
        QVERIFY(besideAxis(scope) < share * kTube);
    }
    // It has 1 mm on each side, and can be taken on, but not out.
    scope.advance(metres(0.02), walls);
    QVERIFY(besideAxis(scope) < 0.1 * kTube);
    narrowedTo(1.0);
    QVERIFY(walls.nearestTo(scope.pose().translation()).distance > kBall - kOver);
}

void TestFlownScope::goesNoFartherThanItsLeash()
{
    // Out of the open end of a tube it goes as far as its leash lets it.
    TriangleMesh open = shutTube();
    open.triangles.resize(open.triangles.size() - 2 * std::size_t{kSides});
    ScopeWalls walls = wallsOf(open);
    FlownScope scope = scopeAt(-0.15);
    scope.advance(metres(1.0), walls);
    const double beyond = -kLength - scope.pose().translation().z();
    QVERIFY(beyond > 0.02 && beyond < FlownScope::kLeash.si);
    scope.advance(metres(-0.06), walls);
    QVERIFY(scope.pose().translation().z() > -kLength);
}

CARINA_TEST(TestFlownScope)

} // namespace carina::flown_scope_test

#include "tst_flown_scope.moc"
