#include "engine/geometry/mesh/triangle_query.h"
#include "tests/support/test_class.h"

namespace carina::triangle_query_test
{
namespace
{

/// One right triangle in the plane z = 0 with its legs of 4 along x and y.
const Corners kTriangle{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};

} // namespace

class TestTriangleQuery : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void takesTheCornersOfItsTriangle()
    {
        const TriangleMesh mesh{.positions = {{9, 9, 9}, {1, 2, 3}, {4, 5, 6}, {7, 8, 0}},
                                .normals = {},
                                .triangles = {{1, 2, 3}}};
        const Corners corners = cornersOf(mesh, mesh.triangles.front());
        QCOMPARE(corners.a, Vec3(1, 2, 3));
        QCOMPARE(corners.b, Vec3(4, 5, 6));
        QCOMPARE(corners.c, Vec3(7, 8, 0));
    }

    void findsItsNearestPoint_data()
    {
        QTest::addColumn<Vec3>("p");
        QTest::addColumn<Vec3>("nearest");
        QTest::newRow("above its inside") << Vec3{1, 1, 3} << Vec3{1, 1, 0};
        QTest::newRow("on it") << Vec3{1, 2, 0} << Vec3{1, 2, 0};
        QTest::newRow("beyond a corner") << Vec3{-3, -4, 1} << Vec3{0, 0, 0};
        QTest::newRow("beside the first edge") << Vec3{3, -2, 5} << Vec3{3, 0, 0};
        QTest::newRow("beside the second edge") << Vec3{4, 4, -1} << Vec3{2, 2, 0};
        QTest::newRow("beside the third edge") << Vec3{-7, 1, 0} << Vec3{0, 1, 0};
    }
    void findsItsNearestPoint()
    {
        QFETCH(Vec3, p);
        QFETCH(Vec3, nearest);
        QVERIFY((nearestPoint(kTriangle, p) - nearest).norm() < 1e-15);
    }

    void findsTheNearestPointOfATriangleWithoutArea()
    {
        const Corners needle{{0, 0, 0}, {2, 0, 0}, {4, 0, 0}};
        QCOMPARE(nearestPoint(needle, {3, 5, 0}), Vec3(3, 0, 0));
        const Corners dot{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}};
        QCOMPARE(nearestPoint(dot, {3, 5, 0}), Vec3(1, 1, 1));
    }

    void squaresTheDistanceToItsNearestPoint()
    {
        QCOMPARE(squaredDistance(kTriangle, {1, 1, 3}), 9.0);
        QCOMPARE(squaredDistance(kTriangle, {-3, -4, 0}), 25.0);
        QCOMPARE(squaredDistance(kTriangle, {2, -2, 0}), 4.0);
    }

    void seesWhatRunsThroughItsInside_data()
    {
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("y");
        QTest::addColumn<double>("from");
        QTest::addColumn<double>("to");
        QTest::addColumn<bool>("through");
        QTest::newRow("through its inside") << 1.0 << 1.0 << 1.0 << -1.0 << true;
        QTest::newRow("the other way") << 1.0 << 1.0 << -1.0 << 1.0 << true;
        QTest::newRow("ends before it") << 1.0 << 1.0 << 2.0 << 1.0 << false;
        QTest::newRow("ends on it") << 1.0 << 1.0 << 2.0 << 0.0 << false;
        QTest::newRow("begins on it") << 1.0 << 1.0 << 0.0 << -2.0 << false;
        QTest::newRow("through an edge") << 2.0 << 0.0 << 1.0 << -1.0 << false;
        QTest::newRow("through a corner") << 0.0 << 0.0 << 1.0 << -1.0 << false;
        QTest::newRow("past the first edge") << 1.0 << -0.5 << 1.0 << -1.0 << false;
        QTest::newRow("past the second edge") << 2.5 << 2.5 << 1.0 << -1.0 << false;
        QTest::newRow("past the third edge") << -0.5 << 1.0 << 1.0 << -1.0 << false;
    }
    void seesWhatRunsThroughItsInside()
    {
        QFETCH(double, x);
        QFETCH(double, y);
        QFETCH(double, from);
        QFETCH(double, to);
        QFETCH(bool, through);
        QCOMPARE(runsThrough(kTriangle, {x, y, from}, {x, y, to}), through);
    }

    void doesNotSeeWhatRunsInItsPlane() { QVERIFY(!runsThrough(kTriangle, {-1, 1, 0}, {5, 1, 0})); }
};

CARINA_TEST(TestTriangleQuery)

} // namespace carina::triangle_query_test

#include "tst_triangle_query.moc"
