#include "engine/anatomy/shapes/implicit_shape.h"
#include "engine/anatomy/shapes/surface_mesher.h"
#include "tests/engine/anatomy/shapes/surface_checks.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace carina::implicit_shape_test
{

class TestImplicitShape : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void roundedCornersAreTightBesideTheFillet();
    void rodsTaperBetweenTheirEnds();
    void ellipsoidsAreExactOnTheirAxes();
    void polygonsAreMeasuredFromBothSides_data();
    void polygonsAreMeasuredFromBothSides();
    void linesGoOnBeyondTheirEndOnly();
    void cutCornersStayBetweenTheirNeighbours();
    void aBallIsMeshedClosedOutwardAndInPlace();
    void twoBallsApartAreBothMeshed();
    void cellsAreSmallerAtAFinePlace();
};

namespace
{

constexpr double kExact = 1e-12;
constexpr double kPi = std::numbers::pi;

} // namespace

void TestImplicitShape::roundedCornersAreTightBesideTheFillet()
{
    QCOMPARE(roundedMin(1.0, 3.0, 2.0), 1.0);
    QCOMPARE(roundedMin(1.0, 1.0, 2.0), 0.5); // a quarter of the blend is added at the corner
    QCOMPARE(roundedMax(1.0, 3.0, 2.0), 3.0);
    QCOMPARE(roundedMax(1.0, 1.0, 2.0), 1.5);
    QCOMPARE(easedStep(1.0, 3.0, 0.0), 0.0);
    QCOMPARE(easedStep(1.0, 3.0, 2.0), 0.5);
    QCOMPARE(easedStep(1.0, 3.0, 1.5), 0.15625); // 3 t^2 - 2 t^3 at a quarter
    QCOMPARE(easedStep(1.0, 3.0, 4.0), 1.0);
}

void TestImplicitShape::rodsTaperBetweenTheirEnds()
{
    const Vec3 a = Vec3::Zero();
    const Vec3 b = 2.0 * Vec3::UnitZ();
    QCOMPARE(rodDistance({3.0, 0.0, 0.0}, a, b, 1.0, 0.5), 2.0);
    QCOMPARE(rodDistance({3.0, 0.0, 1.0}, a, b, 1.0, 0.5), 2.25);
    QCOMPARE(rodDistance({0.0, 0.0, 3.0}, a, b, 1.0, 0.5), 0.5);
    QCOMPARE(rodDistance({0.0, 0.0, -3.0}, a, b, 1.0, 0.5), 2.0);
}

void TestImplicitShape::ellipsoidsAreExactOnTheirAxes()
{
    const Vec3 radii{1.0, 2.0, 4.0};
    for (int axis = 0; axis < 3; ++axis) {
        const Vec3 out = Vec3::Unit(axis);
        QVERIFY(std::abs(ellipsoidDistance(radii[axis] * out, radii)) < kExact);
        QVERIFY(std::abs(ellipsoidDistance((radii[axis] + 0.01) * out, radii) - 0.01) < 1e-3);
    }
    QCOMPARE(ellipsoidDistance(Vec3::Zero(), radii), -1.0);
    QVERIFY(std::abs(ellipseDistance({0.0, 2.0}, {1.0, 2.0})) < kExact);
}

void TestImplicitShape::polygonsAreMeasuredFromBothSides_data()
{
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("y");
    QTest::addColumn<double>("distance");
    QTest::newRow("inside near a side") << 0.5 << 2.0 << -0.5;
    QTest::newRow("outside beside a side") << -1.0 << 2.0 << 1.0;
    QTest::newRow("outside beside a corner") << -3.0 << -4.0 << 5.0;
    QTest::newRow("in the bay") << 3.0 << 3.0 << 1.0;
    QTest::newRow("in an arm") << 3.0 << 1.0 << -1.0;
}

void TestImplicitShape::polygonsAreMeasuredFromBothSides()
{
    // An L: 4 by 4 without its upper right quarter.
    const std::array outline{Vec2{0.0, 0.0}, Vec2{4.0, 0.0}, Vec2{4.0, 2.0},
                             Vec2{2.0, 2.0}, Vec2{2.0, 4.0}, Vec2{0.0, 4.0}};
    QFETCH(double, x);
    QFETCH(double, y);
    QFETCH(double, distance);
    QVERIFY(std::abs(polygonDistance({x, y}, outline) - distance) < kExact);
}

void TestImplicitShape::linesGoOnBeyondTheirEndOnly()
{
    const std::array line{Vec2{0.0, 0.0}, Vec2{2.0, 0.0}, Vec2{2.0, 3.0}};
    const auto is = [&line](const Vec2& p, double along, double off) {
        const AlongLine at = alongLine(p, line);
        return std::abs(at.along - along) < kExact && std::abs(at.off - off) < kExact;
    };
    QVERIFY(is({1.0, -0.5}, 1.0, 0.5));
    QVERIFY(is({-3.0, 4.0}, 0.0, 5.0) || is({-3.0, 4.0}, 6.0, 5.0));
    QVERIFY(is({-3.0, 0.0}, 0.0, 3.0));
    QVERIFY(is({2.5, 1.0}, 3.0, 0.5));
    QVERIFY(is({2.5, 7.0}, 9.0, 0.5));
}

void TestImplicitShape::cutCornersStayBetweenTheirNeighbours()
{
    const std::vector<Vec2> cut = cornersCut({{0.0, 0.0}, {4.0, 0.0}, {4.0, 4.0}}, 1);
    QCOMPARE(cut.size(), std::size_t{6});
    QCOMPARE(cut[0], Vec2(0.0, 0.0));
    QCOMPARE(cut[1], Vec2(1.0, 0.0));
    QCOMPARE(cut[2], Vec2(3.0, 0.0));
    QCOMPARE(cut[3], Vec2(4.0, 1.0));
    QCOMPARE(cut[4], Vec2(4.0, 3.0));
    QCOMPARE(cut[5], Vec2(4.0, 4.0));
    QCOMPARE(cornersCut(cut, 0).size(), std::size_t{6});
}

void TestImplicitShape::aBallIsMeshedClosedOutwardAndInPlace()
{
    constexpr double kRadius = 0.02;
    constexpr double kVoxel = 1e-3;
    const Vec3 centre{0.1, -0.03, 0.007};
    Box bounds;
    bounds.include(centre - Vec3::Constant(kRadius));
    bounds.include(centre + Vec3::Constant(kRadius));
    const TriangleMesh ball = meshOf(
        {bounds, [&](const Vec3& p) { return (p - centre).norm() - kRadius; }}, metres(kVoxel));
    QCOMPARE(test::edgesWithoutPartner(ball), 0);
    const double volume = 4.0 / 3.0 * kPi * std::pow(kRadius, 3);
    QVERIFY(std::abs(signedVolume(ball) / volume - 1.0) < 0.005);
    for (const Vec3f& p : ball.positions)
        QVERIFY(std::abs((p.cast<double>() - centre).norm() - kRadius) < 0.1 * kVoxel);
}

void TestImplicitShape::twoBallsApartAreBothMeshed()
{
    // With empty blocks of the grid between them.
    constexpr double kRadius = 5e-3;
    const Vec3 apart{0.06, 0.0, 0.0};
    Box bounds;
    bounds.include(Vec3::Constant(-kRadius));
    bounds.include(apart + Vec3::Constant(kRadius));
    const TriangleMesh balls = meshOf(
        {bounds, [&](const Vec3& p) { return std::min(p.norm(), (p - apart).norm()) - kRadius; }},
        millimetres(0.5));
    QCOMPARE(test::edgesWithoutPartner(balls), 0);
    const double volume = 8.0 / 3.0 * kPi * std::pow(kRadius, 3);
    QVERIFY(std::abs(signedVolume(balls) / volume - 1.0) < 0.02);
}

/// Still closed and in place, with more and smaller triangles where it is fine.
void TestImplicitShape::cellsAreSmallerAtAFinePlace()
{
    constexpr double kRadius = 0.05;
    const Box bounds{Vec3::Constant(-kRadius), Vec3::Constant(kRadius)};
    const FinePlace fine{{0.0, -kRadius, 0.0}, 0.5, 0.04};
    const TriangleMesh ball =
        meshOf({bounds, [](const Vec3& p) { return p.norm() - kRadius; }}, millimetres(3.0), fine);
    QCOMPARE(test::edgesWithoutPartner(ball), 0);
    QVERIFY(std::abs(signedVolume(ball) / (4.0 / 3.0 * kPi * std::pow(kRadius, 3)) - 1.0) < 0.01);
    const auto near = [&](double y) {
        return std::ranges::count_if(ball.positions, [y](const Vec3f& p) {
            return (p - Vec3f{0.0F, float(y), 0.0F}).norm() < 0.02F;
        });
    };
    QVERIFY2(2 * near(-kRadius) > 3 * near(kRadius),
             qPrintable(QStringLiteral("%1 %2").arg(near(-kRadius)).arg(near(kRadius))));
}

CARINA_TEST(TestImplicitShape)

} // namespace carina::implicit_shape_test

#include "tst_implicit_shape.moc"
