#include "engine/geometry/mesh/surface_query.h"
#include "tests/support/test_class.h"

#include <cmath>
#include <random>

namespace carina::surface_query_test
{
namespace
{

constexpr double kExact = 1e-12; // metres, and shares of a ray

/// One right triangle in the plane z = 2 with its legs of 3 and 4 along x and y.
TriangleMesh rightTriangle()
{
    return {
        .positions = {{0, 0, 2}, {3, 0, 2}, {0, 4, 2}}, .normals = {}, .triangles = {{0, 1, 2}}};
}

/// The cube from -1 to 1 as twelve triangles.
TriangleMesh cube()
{
    TriangleMesh mesh;
    for (int corner = 0; corner < 8; ++corner)
        mesh.positions.emplace_back((corner & 1) != 0 ? 1.F : -1.F, (corner & 2) != 0 ? 1.F : -1.F,
                                    (corner & 4) != 0 ? 1.F : -1.F);
    for (const auto& q : {std::array{0U, 2U, 3U, 1U},
                          {4U, 5U, 7U, 6U},
                          {0U, 1U, 5U, 4U},
                          {2U, 6U, 7U, 3U},
                          {0U, 4U, 6U, 2U},
                          {1U, 3U, 7U, 5U}}) {
        mesh.triangles.push_back({q[0], q[1], q[2]});
        mesh.triangles.push_back({q[0], q[2], q[3]});
    }
    return mesh;
}

} // namespace

class TestSurfaceQuery : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void measuresToTheNearestPointOfATriangle_data()
    {
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("y");
        QTest::addColumn<double>("z");
        QTest::addColumn<double>("distance");
        QTest::newRow("above its inside") << 1.0 << 1.0 << 5.0 << 3.0;
        QTest::newRow("below its inside") << 1.0 << 1.0 << -1.0 << 3.0;
        QTest::newRow("on it") << 0.5 << 0.5 << 2.0 << 0.0;
        QTest::newRow("beyond a corner") << -3.0 << -4.0 << 2.0 << 5.0;
        QTest::newRow("beyond the corner at x = 3") << 7.0 << 0.0 << 5.0 << 5.0;
        QTest::newRow("beyond the corner at y = 4") << 0.0 << 7.0 << -2.0 << 5.0;
        QTest::newRow("beside a leg") << 1.0 << -2.0 << 2.0 << 2.0;
        QTest::newRow("beside the other leg") << -2.0 << 1.0 << 2.0 << 2.0;
        // The hypotenuse 4 x + 3 y = 12: (3, 4) is 12 / 5 beyond it.
        QTest::newRow("beside the hypotenuse") << 3.0 << 4.0 << 2.0 << 2.4;
    }
    void measuresToTheNearestPointOfATriangle()
    {
        QFETCH(double, x);
        QFETCH(double, y);
        QFETCH(double, z);
        QFETCH(double, distance);
        QVERIFY(std::abs(distanceTo(rightTriangle(), Vec3{x, y, z}) - distance) < kExact);
    }

    /// Outside, the cube's distance is that of its box; inside, the way to the nearest wall.
    void measuresToACube()
    {
        std::mt19937 random{7};
        std::uniform_real_distribution<double> anywhere{-3.0, 3.0};
        const TriangleMesh mesh = cube();
        for (int i = 0; i < 500; ++i) {
            const Vec3 p{anywhere(random), anywhere(random), anywhere(random)};
            const Vec3 beyond = (p.cwiseAbs() - Vec3::Ones()).cwiseMax(0.0);
            const double inside = std::max(0.0, 1.0 - p.cwiseAbs().maxCoeff());
            QVERIFY(std::abs(distanceTo(mesh, p) - std::max(beyond.norm(), inside)) < kExact);
            QVERIFY(std::abs(distanceTo(boundsOf(mesh), p) - beyond.norm()) < kExact);
        }
    }

    void measuresToATriangleWithoutArea()
    {
        const TriangleMesh line{.positions = {{0, 0, 0}, {1, 0, 0}, {4, 0, 0}},
                                .normals = {},
                                .triangles = {{0, 1, 2}}};
        QVERIFY(std::abs(distanceTo(line, Vec3{2.0, 3.0, 0.0}) - 3.0) < kExact);
        const TriangleMesh point{.positions = {{1, 0, 0}}, .normals = {}, .triangles = {{0, 0, 0}}};
        QVERIFY(std::abs(distanceTo(point, Vec3{1.0, 2.0, 0.0}) - 2.0) < kExact);
    }

    void findsNothingInAnEmptyMesh()
    {
        QVERIFY(std::isinf(distanceTo(TriangleMesh{}, Vec3::Zero())));
        QVERIFY(!rayHit(TriangleMesh{}, Vec3::Zero(), Vec3::UnitX()));
    }

    void meetsATriangleWhereItIsCrossed_data()
    {
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("y");
        QTest::addColumn<bool>("met");
        QTest::newRow("inside") << 1.0 << 1.0 << true;
        QTest::newRow("at a corner") << 0.0 << 0.0 << true;
        QTest::newRow("on the hypotenuse") << 1.5 << 2.0 << true;
        QTest::newRow("beyond the hypotenuse") << 1.51 << 2.0 << false;
        QTest::newRow("left of a leg") << -0.01 << 1.0 << false;
        QTest::newRow("below a leg") << 1.0 << -0.01 << false;
    }
    void meetsATriangleWhereItIsCrossed()
    {
        QFETCH(double, x);
        QFETCH(double, y);
        QFETCH(bool, met);
        const auto fromBelow = rayHit(rightTriangle(), {x, y, -1.0}, 2.0 * Vec3::UnitZ());
        QCOMPARE(fromBelow.has_value(), met);
        const auto fromAbove = rayHit(rightTriangle(), {x, y, 4.0}, -Vec3::UnitZ());
        QCOMPARE(fromAbove.has_value(), met);
        if (met) {
            QVERIFY(std::abs(*fromBelow - 1.5) < kExact); // 3 m by steps of 2
            QVERIFY(std::abs(*fromAbove - 2.0) < kExact);
        }
    }

    void looksAheadOnly()
    {
        QVERIFY(!rayHit(rightTriangle(), {1.0, 1.0, 3.0}, Vec3::UnitZ()));
        QVERIFY(!rayHit(rightTriangle(), {-1.0, 1.0, 2.0}, Vec3::UnitX())); // along its plane
        QCOMPARE(rayHit(rightTriangle(), {1.0, 1.0, 2.0}, Vec3::UnitZ()), std::optional{0.0});
    }

    void meetsTheNearestSideFirst()
    {
        std::mt19937 random{7};
        std::uniform_real_distribution<double> across{-0.99, 0.99};
        for (int i = 0; i < 100; ++i) {
            const double y = across(random);
            const double z = across(random);
            const auto hit = rayHit(cube(), {5.0, y, z}, -Vec3::UnitX());
            QVERIFY(hit && std::abs(*hit - 4.0) < kExact);
        }
    }
};

CARINA_TEST(TestSurfaceQuery)

} // namespace carina::surface_query_test

#include "tst_surface_query.moc"
