#include "engine/anatomy/shapes/strand.h"
#include "tests/support/test_class.h"

#include <cmath>

namespace carina::strand_test
{

class TestStrand : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isAFlatRod();
    void widensAlongItsWay();
    void boxHoldsIt();
    void smoothLineLeavesAndArrivesAsTold();
    void smoothLineRunsThroughAllPoints();
    void tubeIsTheUnionOfItsPieces();
};

namespace
{

constexpr double kExact = 1e-12;

Strand straight()
{
    return Strand{
        {{Vec3::Zero(), 3.0, 1.0, Vec3::UnitY()}, {Vec3{0.0, 0.0, 10.0}, 3.0, 1.0, Vec3::UnitY()}}};
}

} // namespace

void TestStrand::isAFlatRod()
{
    const Strand s = straight();
    QVERIFY(std::abs(s.distance({0.0, 1.0, 5.0})) < kExact); // its flat side
    QVERIFY(std::abs(s.distance({0.0, -4.0, 5.0}) - 3.0) < kExact);
    QVERIFY(std::abs(s.distance({3.0, 0.0, 5.0})) < kExact);  // its edge
    QVERIFY(std::abs(s.distance({0.0, 0.0, 13.0})) < kExact); // its round end
    QVERIFY(std::abs(s.distance({0.0, 0.0, -5.0}) - 2.0) < kExact);
    QVERIFY(s.distance({0.0, 0.0, 5.0}) < -0.5);
    // Rounded where side and edge meet: more is outside than in a box.
    QVERIFY(s.distance({3.0, 1.0, 5.0}) > 0.1);
    QVERIFY(s.distance({2.0, 0.9, 5.0}) < 0.0);
}

void TestStrand::widensAlongItsWay()
{
    const Strand s{
        {{Vec3::Zero(), 2.0, 1.0, Vec3::UnitY()}, {Vec3{0.0, 0.0, 10.0}, 4.0, 2.0, Vec3::UnitY()}}};
    QVERIFY(std::abs(s.distance({3.0, 0.0, 5.0})) < kExact);
    QVERIFY(std::abs(s.distance({0.0, 1.5, 5.0})) < kExact);
}

void TestStrand::boxHoldsIt()
{
    const Box box = straight().bounds();
    QCOMPARE(box.min, Vec3(-3.0, -3.0, -3.0));
    QCOMPARE(box.max, Vec3(3.0, 3.0, 13.0));
    const ImplicitShape shape = straight().shape();
    QCOMPARE(shape.bounds.max, box.max);
    QCOMPARE(shape.distance({0.0, 4.0, 5.0}), 3.0);
}

void TestStrand::smoothLineLeavesAndArrivesAsTold()
{
    const Vec3 to{1.0, 1.0, 0.0};
    const auto line = smoothLine(Vec3::Zero(), Vec3::UnitX(), to, Vec3::UnitY(), 1000);
    QCOMPARE(line.size(), std::size_t{1000});
    QCOMPARE(line.front(), Vec3::Zero().eval());
    QVERIFY((1000.0 * (line[1] - line[0]) - Vec3::UnitX()).norm() < 0.01);
    QVERIFY((1000.0 * (to - line.back()) - Vec3::UnitY()).norm() < 0.01);
    // A straight way at even speed stays even.
    const auto even = smoothLine(Vec3::Zero(), to, to, to, 4);
    QVERIFY((even[1] - 0.25 * to).norm() < kExact);
}

void TestStrand::smoothLineRunsThroughAllPoints()
{
    const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {1, 2, 0}, {0, 2, 5}};
    const auto line = smoothThrough(points, 7);
    QCOMPARE(line.size(), std::size_t{22});
    for (std::size_t i = 0; i < points.size(); ++i)
        QVERIFY((line[7 * i] - points[i]).norm() < kExact);
    // At an inner point it runs along the line between its neighbours.
    const auto fine = smoothThrough(points, 1000);
    const Vec3 across = (fine[1001] - fine[999]).normalized();
    QVERIFY((across - Vec3{1.0, 2.0, 0.0}.normalized()).norm() < 0.01);
}

void TestStrand::tubeIsTheUnionOfItsPieces()
{
    const std::vector<Vec3> line{{0, 0, 0}, {0, 0, 10}, {10, 0, 10}};
    const std::vector<double> radii{1.0, 2.0, 2.0};
    QVERIFY(std::abs(tubeDistance({3.0, 0.0, 5.0}, line, radii) - 1.5) < kExact);
    QVERIFY(std::abs(tubeDistance({5.0, 4.0, 10.0}, line, radii) - 2.0) < kExact);
}

CARINA_TEST(TestStrand)

} // namespace carina::strand_test

#include "tst_strand.moc"
