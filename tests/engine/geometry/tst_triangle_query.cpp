#include "engine/geometry/triangle_query.h"

#include <QTest>

namespace carina
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

} // namespace carina

QTEST_APPLESS_MAIN(carina::TestTriangleQuery)
#include "tst_triangle_query.moc"
