#include "engine/airway/form/tube_form.h"
#include "engine/airway/tube/tube_in_lumen.h"
#include "engine/geometry/rotation.h"
#include "tests/engine/airway/tube/bent_lumen.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace carina::tube_form_test
{
namespace
{

constexpr double kNear_m = 1e-3;
constexpr double kPieces_m = 3e-4; ///< by which a line of pieces is off from an arc
constexpr double kExact_m = 1e-5;  ///< of a line that the eight numbers tell
constexpr Length kLong = metres(0.3);
constexpr int kPieces = TubeInLumen::kPieces;

RigidTransform turnedBy(double angle)
{
    return {rotationFromVector(angle * Vec3::UnitZ()), Vec3::Zero()};
}

/// As a tube that was touched: two arcs that bend towards -y.
std::vector<Vec3> touchedCurve(const TubeSize& size)
{
    return lineOf({.length = size.length, .entry = size.length, .perMetre = {-6.2, -7.1}}, 200);
}

double farthest(std::span<const Vec3> a, std::span<const Vec3> b)
{
    double most = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
        most = std::max(most, (a[i] - b[i]).norm());
    return most;
}

} // namespace

class TestTubeForm : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isStraightInZeros()
    {
        const std::vector<Vec3> line = lineOf({.length = kLong, .entry = metres(0.1)}, 10);
        QCOMPARE(line.size(), std::size_t{11});
        for (int i = 0; i <= 10; ++i)
            QVERIFY((line[std::size_t(i)] - Vec3{0.0, 0.0, -0.03 * i}).norm() < 1e-12);
    }

    /// About x of the connector, wherever the median plane is.
    void isTwoArcsOutsideOfTheMouth()
    {
        constexpr double kRadius = 0.14;
        constexpr double kFurther = 0.1; // radius of the second half
        const TubeForm form{.length = kLong,
                            .entry = kLong,
                            .plane = radians(0.7),
                            .perMetre = {1.0 / kRadius, 1.0 / kFurther}};
        const std::vector<Vec3> line = lineOf(form, kPieces);
        const auto onArc = [](double radius, double from, double angle) -> Vec3 {
            return radius
                   * Vec3{0.0, std::cos(from) - std::cos(from + angle),
                          std::sin(from) - std::sin(from + angle)};
        };
        const double turned = 0.15 / kRadius;
        const Vec3 middle = onArc(kRadius, 0.0, turned);
        const double end = 0.3 - TubeForm::kPassage.si; // where it begins to enter
        for (int i = 0; i <= kPieces; ++i) {
            const double s = 0.3 * i / kPieces;
            if (s > end)
                break;
            const Vec3 there = s < 0.15
                                   ? onArc(kRadius, 0.0, s / kRadius)
                                   : Vec3{middle + onArc(kFurther, turned, (s - 0.15) / kFurther)};
            QVERIFY((line[std::size_t(i)] - there).norm() < kPieces_m);
        }
    }

    void isFoundAgain_data()
    {
        QTest::addColumn<double>("entry");
        QTest::addColumn<double>("plane");
        QTest::newRow("in the mouth") << 0.26 << 0.0;
        QTest::newRow("deep") << 0.08 << 0.0;
        QTest::newRow("turned") << 0.1 << 1.2;
        QTest::newRow("turned back") << 0.1 << -2.9;
    }

    void isFoundAgain()
    {
        QFETCH(double, entry);
        QFETCH(double, plane);
        const TubeForm form{.length = kLong,
                            .entry = metres(entry),
                            .plane = radians(plane),
                            .perMetre = {6.0, 5.0, -8.0, 3.0, 2.0, -1.0, 2.0, 9.0}};
        const std::vector<Vec3> line = lineOf(form, kPieces);
        const TubeForm found = formOf(line, form.length, form.entry, form.plane);
        QVERIFY(farthest(lineOf(found, kPieces), line) < kExact_m);
    }

    /// However a connector is turned about itself, the plane goes with the patient.
    void findsTheMedianPlane()
    {
        const RigidTransform X_AE{rotationFromVector({0.8, 0.0, 0.0}), {0.1, 0.2, 0.3}};
        QVERIFY(std::abs(medianPlane(X_AE).si) < 1e-12);
        for (const double turn : {0.5, -1.0, 3.0})
            QVERIFY(std::abs(std::remainder(medianPlane(X_AE * turnedBy(turn)).si + turn,
                                            2.0 * std::numbers::pi))
                    < 1e-12);
        const RigidTransform across{rotationFromVector(0.5 * std::numbers::pi * Vec3::UnitY()),
                                    Vec3::Zero()};
        QCOMPARE(medianPlane(across).si, 0.0);
    }

    void hasATubeInAnAirway_data()
    {
        QTest::addColumn<double>("bend");
        QTest::addColumn<double>("turn");
        QTest::newRow("bent sharply") << 0.045 << 0.0;
        QTest::newRow("bent") << 0.06 << 0.0;
        QTest::newRow("turned a little in the hand") << 0.06 << 0.3;
        QTest::newRow("turned in the hand") << 0.06 << -0.6;
    }

    /// From in front of the teeth to the trachea.
    void hasATubeInAnAirway()
    {
        QFETCH(double, bend);
        QFETCH(double, turn);
        constexpr double kStep = 0.0015;
        const test::BentLumen airway{.bend = bend, .radius = 0.01};
        const TubeSize size = *tubeOfSize(millimetres(7.0));
        TubeInLumen tube{size, touchedCurve(size)};
        const MovedLumen lumen = unmoved(airway.lumenFor(size.outerRadius()));
        int steps = 0;
        double most = 0.0;
        for (double inside = -0.02; inside < 0.2; inside += kStep) {
            const RigidTransform X_AE = test::fed(size, inside) * turnedBy(turn);
            tube.step(X_AE, lumen);
            if (++steps % 10 != 0)
                continue;
            std::vector<Vec3> p_E;
            for (const Vec3& p_A : tube.constrained())
                p_E.push_back(X_AE.inverse() * p_A);
            const TubeForm form =
                formOf(p_E, size.length, size.length - tube.tip().depth, medianPlane(X_AE));
            most = std::max(most, farthest(lineOf(form, kPieces), p_E));
        }
        QVERIFY2(most < kNear_m, qPrintable(QStringLiteral("%1 mm").arg(1e3 * most)));
    }
};

CARINA_TEST(TestTubeForm)

} // namespace carina::tube_form_test

#include "tst_tube_form.moc"
