#include "engine/airway/tube/tube_in_lumen.h"
#include "engine/airway/tube/tube_shape_code.h"
#include "engine/geometry/rotation.h"
#include "tests/engine/airway/lumen/still_lumen.h"
#include "tests/engine/airway/tube/bent_lumen.h"
#include "tests/support/test_class.h"

#include <cmath>

namespace carina::tube_shape_code_test
{
namespace
{

constexpr Length kShape = millimetres(1.0);

/// In 64 pieces along -z.
std::vector<Vec3> straight(double length)
{
    std::vector<Vec3> line;
    for (int i = 0; i <= 64; ++i)
        line.emplace_back(0.0, 0.0, -length * i / 64.0);
    return line;
}

} // namespace

class TestTubeShapeCode : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void hasAStraightTubeInZeros();
    void hasACircleInOneNumber();
    void goesWithTheConnector();
    void isNothingForATubeAtRest();
    void goesWithTheCurveAtRest();
    void hasATubeInAnAirway_data();
    void hasATubeInAnAirway();
};

void TestTubeShapeCode::hasAStraightTubeInZeros()
{
    const std::vector<Vec3> p_E_rest = straight(0.3);
    const std::vector<Vec3> line = decoded({}, p_E_rest);
    QCOMPARE(line.size(), p_E_rest.size());
    for (std::size_t i = 0; i < line.size(); ++i)
        QVERIFY((line[i] - p_E_rest[i]).norm() < 1e-12);
}

void TestTubeShapeCode::hasACircleInOneNumber()
{
    // A curvature of 1 / 0.14 m about x: towards -y or +y along a circle.
    constexpr double kNear = 2e-4; // metres, of 64 chords
    TubeShapeCode code;
    code.perMetre[0] = float(-1.0 / 0.14);
    const std::vector<Vec3> line = decoded(code, straight(0.2));
    const double side = line.back().y() > 0.0 ? 0.14 : -0.14;
    for (const Vec3& p : line)
        QVERIFY(std::abs((p - Vec3{0.0, side, 0.0}).norm() - 0.14) < kNear);
    QCOMPARE(line.back().x(), 0.0);
}

void TestTubeShapeCode::goesWithTheConnector()
{
    TubeShapeCode code;
    code.perMetre = {-6.0F, 2.0F, -1.0F, 1.5F, 0.0F, 0.5F, 1.0F, -0.5F};
    const std::vector<Vec3> p_E_rest = straight(0.3);
    const RigidTransform X_AE{rotationFromVector({0.3, -1.0, 0.7}), {0.1, -0.2, 0.3}};
    std::vector<Vec3> p_A;
    for (const Vec3& p_E : decoded(code, p_E_rest))
        p_A.push_back(X_AE * p_E);
    const EncodedShape shape = encoded(p_A, X_AE, p_E_rest);
    QVERIFY(shape.error < millimetres(0.01));
    for (std::size_t i = 0; i < code.perMetre.size(); ++i)
        QVERIFY(std::abs(shape.code.perMetre[i] - code.perMetre[i]) < 0.01F);
}

void TestTubeShapeCode::isNothingForATubeAtRest()
{
    constexpr Length kNear = millimetres(0.001);
    const TubeSize size = *tubeOfSize(millimetres(7.0));
    const std::vector<Vec3> p_E_rest = inPieces(test::restCurve(size), 64);
    const std::vector<Vec3> line = decoded({}, p_E_rest);
    for (std::size_t i = 0; i < line.size(); ++i)
        QVERIFY((line[i] - p_E_rest[i]).norm() < 1e-9);
    QVERIFY(encoded(line, {}, line).error < kNear);
    for (const float number : encoded(line, {}, line).code.perMetre)
        QVERIFY(std::abs(number) < 1e-3F);
}

void TestTubeShapeCode::goesWithTheCurveAtRest()
{
    TubeShapeCode code;
    code.perMetre = {-6.0F, 2.0F, -1.0F, 1.5F, 0.0F, 0.5F, 1.0F, -0.5F};
    const std::vector<Vec3> p_E_rest =
        decoded({}, inPieces(test::restCurve(*tubeOfSize(millimetres(7.0))), 64));
    const RigidTransform X_AE{rotationFromVector({0.3, -1.0, 0.7}), {0.1, -0.2, 0.3}};
    std::vector<Vec3> p_A;
    for (const Vec3& p_E : decoded(code, p_E_rest))
        p_A.push_back(X_AE * p_E);
    const EncodedShape shape = encoded(p_A, X_AE, p_E_rest);
    QVERIFY(shape.error < millimetres(0.01));
    for (std::size_t i = 0; i < code.perMetre.size(); ++i)
        QVERIFY(std::abs(shape.code.perMetre[i] - code.perMetre[i]) < 0.01F);
}

void TestTubeShapeCode::hasATubeInAnAirway_data()
{
    QTest::addColumn<double>("bend");
    QTest::newRow("bent sharply") << 0.045;
    QTest::newRow("bent") << 0.06;
}

void TestTubeShapeCode::hasATubeInAnAirway()
{
    // While it is pushed in, and at rest there.
    QFETCH(double, bend);
    const test::BentLumen airway{.bend = bend, .radius = 0.01};
    const TubeSize size = *tubeOfSize(millimetres(7.0));
    const std::vector<Vec3> p_E_rest = inPieces(test::restCurve(size), TubeInLumen::kPieces);
    TubeInLumen tube{size, test::restCurve(size)};
    const MovedLumen lumen = test::unmoved(airway.lumenFor(size.outerRadius()));
    constexpr int kEach = 10; // steps
    int step = 0;
    for (double inside = -0.02; inside < 0.2; inside += 0.0015) {
        const RigidTransform X_AE = test::fed(size, inside);
        tube.step(X_AE, lumen);
        if (++step % kEach == 0)
            QVERIFY(encoded(tube.constrained(), X_AE, p_E_rest).error < kShape);
    }
    const RigidTransform X_AE = test::fed(size, 0.2);
    for (int i = 0; i < 60; ++i)
        tube.step(X_AE, lumen);
    const EncodedShape shape = encoded(tube.constrained(), X_AE, p_E_rest);
    const std::vector<Vec3> p_E = decoded(shape.code, p_E_rest);
    QCOMPARE(p_E.size(), tube.constrained().size());
    for (std::size_t i = 0; i < p_E.size(); ++i)
        QVERIFY((X_AE * p_E[i] - tube.constrained()[i]).norm() < kShape.si);
}

CARINA_TEST(TestTubeShapeCode)

} // namespace carina::tube_shape_code_test

#include "tst_tube_shape_code.moc"
