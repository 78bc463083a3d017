#include "engine/anatomy/airway/centreline.h"
#include "tests/support/test_class.h"

#include <array>
#include <cmath>

namespace carina::centreline_test
{

class TestCentreline : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void lengthIsTheSumOfItsSteps();
    void pointsLieAtTheirWayAlongIt_data();
    void pointsLieAtTheirWayAlongIt();
    void evenSpacingKeepsBothEnds();
};

namespace
{

/// 3 m along x, then 4 m along y.
const std::array<Vec3, 3> kCorner{Vec3{0.0, 0.0, 0.0}, Vec3{3.0, 0.0, 0.0}, Vec3{3.0, 4.0, 0.0}};
constexpr double kExact = 1e-12; // metres

} // namespace

void TestCentreline::lengthIsTheSumOfItsSteps()
{
    QCOMPARE(lengthOf(kCorner).si, 7.0);
    QCOMPARE(lengthOf(std::span{kCorner}.first(1)).si, 0.0);
    QCOMPARE(lengthOf({}).si, 0.0);
}

void TestCentreline::pointsLieAtTheirWayAlongIt_data()
{
    QTest::addColumn<double>("along");
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("y");
    QTest::newRow("before the start") << -1.0 << 0.0 << 0.0;
    QTest::newRow("start") << 0.0 << 0.0 << 0.0;
    QTest::newRow("first step") << 2.0 << 2.0 << 0.0;
    QTest::newRow("corner") << 3.0 << 3.0 << 0.0;
    QTest::newRow("second step") << 5.5 << 3.0 << 2.5;
    QTest::newRow("end") << 7.0 << 3.0 << 4.0;
    QTest::newRow("beyond the end") << 9.0 << 3.0 << 4.0;
}

void TestCentreline::pointsLieAtTheirWayAlongIt()
{
    QFETCH(double, along);
    QFETCH(double, x);
    QFETCH(double, y);
    QVERIFY((pointAlong(kCorner, metres(along)) - Vec3{x, y, 0.0}).norm() < kExact);
}

void TestCentreline::evenSpacingKeepsBothEnds()
{
    const Centreline even = evenlySpaced(kCorner, metres(2.0));
    QCOMPARE(even.size(), std::size_t{5}); // four steps of 1.75 m
    QVERIFY((even[1] - Vec3{1.75, 0.0, 0.0}).norm() < kExact);
    QVERIFY((even[2] - Vec3{3.0, 0.5, 0.0}).norm() < kExact);
    QVERIFY((even.front() - kCorner.front()).norm() < kExact);
    QVERIFY((even.back() - kCorner.back()).norm() < kExact);
}

CARINA_TEST(TestCentreline)

} // namespace carina::centreline_test

#include "tst_centreline.moc"
