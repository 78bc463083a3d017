#include "engine/airway/lumen/measured_lumen.h"
#include "engine/anatomy/patient/builtin_patient.h"
#include "engine/anatomy/shapes/tube.h"
#include "engine/geometry/mesh/surface_tree.h"
#include "tests/engine/airway/lumen/still_lumen.h"
#include "tests/support/test_class.h"

namespace carina::measured_lumen_test
{
namespace
{

using test::unmoved;

constexpr Length kInTriangles = millimetres(0.5);

const Anatomy& adult()
{
    static const Anatomy anatomy = builtinPatient(BuiltinPatient::Adult).value();
    return anatomy;
}

} // namespace

class TestMeasuredLumen : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void hasEveryWay();
    void liesWithinTheTrachea();
    void letsATubeThroughThatFits();
    void stopsATubeThatIsTooThick();
    void refusesWhatIsNoAirway();
};

void TestMeasuredLumen::hasEveryWay()
{
    const auto lumen =
        measuredLumen(adult().parts, adult().landmarks, 0.5 * outerDiameterOf(millimetres(7.0)));
    QVERIFY(lumen.has_value());
    QVERIFY(lumen->isMeasured);
    for (const AirwayWay which : kAllAirwayWays)
        QVERIFY(lumen->way(which).size() >= 2);
    QVERIFY(lumen->teeth > 0 && lumen->glottis > lumen->teeth);
    const Vec3 right = lumen->way(AirwayWay::RightMain).back().p_A_centre;
    const Vec3 left = lumen->way(AirwayWay::LeftMain).back().p_A_centre;
    QVERIFY(right.x() < 0.0 && left.x() > 0.0 && right.z() < 0.0 && left.z() < 0.0);
}

void TestMeasuredLumen::liesWithinTheTrachea()
{
    const Length radius = 0.5 * outerDiameterOf(millimetres(7.0));
    const auto lumen = measuredLumen(adult().parts, adult().landmarks, radius);
    QVERIFY(lumen.has_value());
    for (const AnatomyPart& part : adult().parts) {
        if (part.role != PartRole::Trachea)
            continue;
        const SurfaceTree surface{part.levels.front()};
        // As far as above the carina, whose ridge tubes pass at its sides.
        for (std::size_t i = lumen->glottis + 5; i + 5 < lumen->way(AirwayWay::Trunk).size(); ++i)
            for (const LumenLimit& limit : lumen->way(AirwayWay::Trunk)[i].limits)
                QVERIFY(surface.distanceTo(limit.p_A_wall + limit.fromWall)
                        > radius.si - kInTriangles.si);
    }
}

void TestMeasuredLumen::letsATubeThroughThatFits()
{
    for (const double inner_mm : {6.0, 7.0, 8.0}) {
        const auto lumen = measuredLumen(adult().parts, adult().landmarks,
                                         0.5 * outerDiameterOf(millimetres(inner_mm)));
        QVERIFY(lumen.has_value());
        const MovedWay trunk = unmoved(*lumen).way(AirwayWay::Trunk);
        QCOMPARE(trunk.stopBehind(0.0), trunk.along.back());
    }
}

void TestMeasuredLumen::stopsATubeThatIsTooThick()
{
    // 18 mm, in a man's trachea of about that width outside.
    const auto lumen = measuredLumen(adult().parts, adult().landmarks, millimetres(9.0));
    QVERIFY(lumen.has_value());
    const MovedLumen still = unmoved(*lumen);
    QVERIFY(still.way(AirwayWay::Trunk).stopBehind(0.0)
            < still.way(AirwayWay::Trunk).along.back() - 0.05);
}

void TestMeasuredLumen::refusesWhatIsNoAirway()
{
    QVERIFY(!measuredLumen({}, AirwayLandmarks{}, millimetres(5.0)));
    QVERIFY(!measuredLumen(adult().parts, adult().landmarks, millimetres(0.5)));
}

CARINA_TEST(TestMeasuredLumen)

} // namespace carina::measured_lumen_test

#include "tst_measured_lumen.moc"
