#include "engine/geometry/deformation/chest_field.h"

#include "tests/engine/geometry/mesh/mesh_of_places.h"
#include "tests/support/test_class.h"

#include <Eigen/LU>

#include <numbers>
#include <random>

namespace carina::chest_field_test
{
namespace
{

constexpr double kStep_m = 1e-5;
/// Central differences err by the square of their step; at the seams of the field, where its second
/// derivative jumps, by the step.
constexpr double kSlopeTolerance = 2e-4;
constexpr double kNormalTolerance = 1e-5;     // of a unit vector, single precision
constexpr double kPositionTolerance_m = 5e-8; // single precision within a quarter metre

const Vec3 kRightHilum{-0.055, 0.01, -0.01};
const Vec3 kLeftHilum{0.03, 0.0, 0.005};

ChestField chest()
{
    Box lungs_A;
    lungs_A.include(Vec3{-0.14, -0.10, -0.15});
    lungs_A.include(Vec3{0.12, 0.09, 0.10});
    return {lungs_A, kRightHilum, kLeftHilum};
}

/// Terms as of a deep breath, all at work and different on both sides.
ChestMotion everything()
{
    return {{0.30, -0.08, 0.10, -0.06, 0.15, 0.04, 0.12, 0.10},
            {0.15, -0.02, 0.05, 0.03, -0.10, 0.01, 0.02, 0.04}};
}

std::vector<Vec3> places()
{
    std::mt19937 random{7};
    std::uniform_real_distribution<double> x{-0.17, 0.15};
    std::uniform_real_distribution<double> y{-0.14, 0.13};
    std::uniform_real_distribution<double> z{-0.20, 0.15};
    std::vector<Vec3> made;
    for (int n = 0; n < 2000; ++n)
        made.emplace_back(x(random), y(random), z(random));
    return made;
}

Vec3 movedTo(const Vec3& p_A, const ChestMotion& motion)
{
    return p_A + chest().at(p_A, motion).d_A;
}

/// Of a surface through p_A with the normal n, the normal where the motion takes it, from
/// differences along it.
Vec3 normalByDifferences(const Vec3& p_A, const Vec3& n, const ChestMotion& motion)
{
    const Vec3 s = n.unitOrthogonal();
    const Vec3 t = n.cross(s);
    const auto along = [&](const Vec3& d) {
        return Vec3{movedTo(p_A + kStep_m * d, motion) - movedTo(p_A - kStep_m * d, motion)};
    };
    return along(s).cross(along(t)).normalized();
}

} // namespace

class TestChestField : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void tellsPlacesInSharesOfTheChest();
    void movesHilaToTheirSides();
    void hasTheSlopesOfItsDisplacement_data();
    void hasTheSlopesOfItsDisplacement();
    void holdsStillOnTheLineBetweenTheHila();
    void goesOverFromOneLungIntoTheOther();
    void lowersTheBaseByWhatItIsTold();
    void movesTheFrontAndTheSides();
    void keepsTheInsideWithinTheWalls();
    void shrinksTowardsTheHilum();
    void shiftsTheMiddleAndNotTheWalls();
    void deformsMeshesAsTheFieldSays();
    void movesNothingWithoutMotion();
};

void TestChestField::tellsPlacesInSharesOfTheChest()
{
    QVERIFY((chest().shares({-0.14, -0.10, 0.10}) - Vec3{-1.0, 0.0, 0.0}).norm() < 1e-12);
    QVERIFY((chest().shares({0.12, 0.09, -0.15}) - Vec3{1.0, 1.0, 1.0}).norm() < 1e-12);
    QVERIFY(chest().shares({-0.01, -0.005, -0.025}).isApprox(Vec3{0.0, 0.5, 0.5}, 1e-9));
}

void TestChestField::movesHilaToTheirSides()
{
    Box lungs_A;
    lungs_A.include(Vec3{-1.0, 0.0, 0.0});
    lungs_A.include(Vec3{1.0, 1.0, 1.0});
    const ChestField field{lungs_A, {0.4, 0.5, 0.5}, {-0.1, 0.5, 0.5}};
    QCOMPARE(field.frame().rightHilum.u, -ChestField::kLeastHilum);
    QCOMPARE(field.frame().leftHilum.u, ChestField::kLeastHilum);
}

void TestChestField::hasTheSlopesOfItsDisplacement_data()
{
    QTest::addColumn<ChestMotion>("motion");
    QTest::newRow("everything") << everything();
    const auto both = [](const ChestTerms<double>& c) { return ChestMotion{c, c}; };
    QTest::newRow("descent") << both({.descent = 0.3});
    QTest::newRow("forward") << both({.forward = -0.1});
    QTest::newRow("flare") << both({.flare = 0.1});
    QTest::newRow("lift") << both({.lift = -0.1});
    QTest::newRow("bulk back") << both({.bulkBack = 0.2});
    QTest::newRow("bulk down") << both({.bulkDown = 0.2});
    QTest::newRow("shrink") << both({.shrink = 0.3});
    QTest::newRow("shift") << both({.shift = 0.2});
    QTest::newRow("shrink on one side") << ChestMotion{{.shrink = 0.3}, {}};
    QTest::newRow("descent on one side") << ChestMotion{{}, {.descent = 0.3}};
}

void TestChestField::hasTheSlopesOfItsDisplacement()
{
    QFETCH(ChestMotion, motion);
    for (const Vec3& p_A : places()) {
        const Mat3 gradient = chest().at(p_A, motion).gradient;
        for (int axis = 0; axis < 3; ++axis) {
            const Vec3 step = kStep_m * Vec3::Unit(axis);
            const Vec3 slope =
                (chest().at(p_A + step, motion).d_A - chest().at(p_A - step, motion).d_A)
                / (2.0 * kStep_m);
            QVERIFY((slope - gradient.col(axis)).cwiseAbs().maxCoeff() < kSlopeTolerance);
        }
    }
}

void TestChestField::holdsStillOnTheLineBetweenTheHila()
{
    ChestMotion motion = everything();
    for (ChestTerms<double>* side : {&motion.right, &motion.left}) {
        side->shrink = 0.0;
        side->shift = 0.0;
    }
    for (const Vec3& hilum : {kRightHilum, kLeftHilum}) {
        QVERIFY(chest().at(hilum, motion).d_A.norm() < 1e-15);
        QVERIFY(chest().at(hilum, motion).gradient.norm() < 1e-12);
    }
    // The way between them is a smooth step from one height to the other.
    for (const double t : {0.25, 0.5, 0.75}) {
        Vec3 p_A = kRightHilum + t * t * (3.0 - 2.0 * t) * (kLeftHilum - kRightHilum);
        p_A.x() = kRightHilum.x() + t * (kLeftHilum.x() - kRightHilum.x());
        QVERIFY(chest().at(p_A, motion).d_A.norm() < 1e-15);
    }
}

void TestChestField::goesOverFromOneLungIntoTheOther()
{
    const ChestMotion motion = everything();
    const ChestMotion right{motion.right, motion.right};
    const ChestMotion left{motion.left, motion.left};
    for (Vec3 p_A : places()) {
        const Vec3 expected = p_A.x() < kRightHilum.x()  ? chest().at(p_A, right).d_A
                              : p_A.x() > kLeftHilum.x() ? chest().at(p_A, left).d_A
                                                         : chest().at(p_A, motion).d_A;
        QVERIFY((chest().at(p_A, motion).d_A - expected).norm() < 1e-15);
        p_A.x() = 0.5 * (kRightHilum.x() + kLeftHilum.x());
        const Vec3 mean = 0.5 * (chest().at(p_A, right).d_A + chest().at(p_A, left).d_A);
        QVERIFY((chest().at(p_A, motion).d_A - mean).norm() < 1e-12);
    }
}

// Far from the hila (rho = 16 (0.7)^2 + ... > 7) at most 1 / (1 + 7)^2 = 1.6 % is held back.
void TestChestField::lowersTheBaseByWhatItIsTold()
{
    const ChestMotion motion{{.descent = 0.1}, {.descent = 0.1}};
    const double height = 0.25;
    const double behind = -chest().at({-0.14, 0.13, -0.15}, motion).d_A.z();
    QVERIFY(behind < 0.1 * height && behind > 0.984 * 0.1 * height);
    const double inFront = -chest().at({-0.14, -0.14, -0.15}, motion).d_A.z();
    QVERIFY(std::abs(inFront / behind - ChestField::kFrontShare) < 0.002);
    QCOMPARE(chest().at({-0.1, 0.0, 0.10}, motion).d_A.norm(), 0.0);
    QCOMPARE(chest().at({-0.1, 0.0, 0.15}, motion).d_A.norm(), 0.0);
    // Below the base it fades to the attachment of the diaphragm, which stays.
    const double below = -chest().at({-0.14, 0.13, -0.20}, motion).d_A.z();
    QVERIFY(below > 0.5 * behind && below < 0.9 * behind);
    QVERIFY(chest().at({-0.14, 0.13, -0.32}, motion).d_A.norm() < 1e-12);
}

void TestChestField::movesTheFrontAndTheSides()
{
    const ChestMotion motion{{.forward = -0.05, .flare = 0.04, .lift = -0.03},
                             {.forward = -0.05, .flare = 0.04, .lift = -0.03}};
    const Vec3 front = chest().at({-0.01, -0.14, -0.10}, motion).d_A;
    QVERIFY(std::abs(front.x()) < 1e-6);
    QVERIFY(front.y() < -0.9 * 0.05 * 0.19 && front.z() > 0.9 * 0.03 * 0.25);
    const Vec3 right = chest().at({-0.14, -0.14, -0.05}, motion).d_A;
    const Vec3 left = chest().at({0.12, -0.14, -0.05}, motion).d_A;
    QVERIFY(right.x() < -0.98 * 0.04 * 0.13 && left.x() > 0.98 * 0.04 * 0.13);
    QVERIFY(chest().at({-0.14, 0.13, -0.05}, motion).d_A.norm() < 1e-12); // the back is held
}

void TestChestField::keepsTheInsideWithinTheWalls()
{
    const ChestMotion motion{{.bulkBack = 0.05, .bulkDown = 0.02},
                             {.bulkBack = 0.05, .bulkDown = 0.02}};
    for (const Vec3& wall : {Vec3{-0.1, -0.10, -0.03}, Vec3{-0.1, 0.09, -0.03},
                             Vec3{-0.1, 0.0, 0.10}, Vec3{-0.1, 0.0, -0.15}, Vec3{-0.1, 0.2, 0.0}})
        QVERIFY(chest().at(wall, motion).d_A.norm() < 1e-15);
    const Vec3 inside = chest().at({-0.14, -0.005, -0.025}, motion).d_A;
    QVERIFY(inside.y() > 0.98 * 0.05 * 0.19 && inside.y() <= 0.05 * 0.19);
    QVERIFY(-inside.z() > 0.98 * 0.02 * 0.25 && -inside.z() <= 0.02 * 0.25);
}

void TestChestField::shrinksTowardsTheHilum()
{
    const ChestMotion motion{{.shrink = 0.3}, {}};
    for (const Vec3& p_A : {Vec3{-0.14, 0.05, -0.15}, Vec3{-0.06, -0.1, 0.09}}) {
        const Vec3 expected = kRightHilum + 0.7 * (p_A - kRightHilum);
        QVERIFY((movedTo(p_A, motion) - expected).norm() < 1e-12);
    }
    QCOMPARE(chest().at({0.1, 0.0, -0.1}, motion).d_A.norm(), 0.0);
}

void TestChestField::shiftsTheMiddleAndNotTheWalls()
{
    const ChestMotion motion{{.shift = 0.2}, {.shift = 0.2}};
    const Vec3 heart = chest().at({-0.01, 0.0, -0.08}, motion).d_A;
    QVERIFY((heart - Vec3{0.2 * 0.13, 0.0, 0.0}).norm() < 1e-12);
    for (const double x : {-0.14, -0.16, 0.12, 0.2})
        QCOMPARE(chest().at({x, 0.0, -0.08}, motion).d_A.norm(), 0.0);
    QCOMPARE(chest().at({0.0, 0.0, 0.18}, motion).d_A.norm(), 0.0); // the larynx
}

void TestChestField::deformsMeshesAsTheFieldSays()
{
    const TriangleMesh mesh = test::meshOf(places());
    const TriangleMesh moved = deformed(mesh, chest(), everything());
    QCOMPARE(moved.triangles, mesh.triangles);
    QCOMPARE(moved.positions.size(), mesh.positions.size());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const Vec3 p_A = mesh.positions[i].cast<double>();
        const Vec3 n = mesh.normals[i].cast<double>();
        QVERIFY(
            (moved.positions[i].cast<double>() - movedTo(p_A, everything())).cwiseAbs().maxCoeff()
            < kPositionTolerance_m);
        const Vec3 expected = normalByDifferences(p_A, n, everything());
        QVERIFY((moved.normals[i].cast<double>() - expected).norm() < 2e-4);
        const Mat3 j = Mat3::Identity() + chest().at(p_A, everything()).gradient;
        const Vec3 exact = (j.inverse().transpose() * n).normalized();
        QVERIFY((moved.normals[i].cast<double>() - exact).norm() < kNormalTolerance);
    }
}

void TestChestField::movesNothingWithoutMotion()
{
    for (const Vec3& p_A : places()) {
        QCOMPARE(chest().at(p_A, {}).d_A.norm(), 0.0);
        QCOMPARE(chest().at(p_A, {}).gradient.norm(), 0.0);
    }
    QVERIFY(deformed({}, ChestField{}, everything()).positions.empty());
}

CARINA_TEST(TestChestField)

} // namespace carina::chest_field_test

#include "tst_chest_field.moc"
