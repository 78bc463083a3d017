#include "engine/anatomy/events/mouth_opening.h"

#include "engine/geometry/rotation.h"
#include "tests/support/test_class.h"

#include <cmath>

namespace carina::mouth_opening_test
{
namespace
{

constexpr double kSmall_m = 1e-12;

/// A mouth open by so much about a hinge behind and above the incisors, brought forward.
RigidTransform openJaw(Angle opening, double forward_m)
{
    const Vec3 p_A_hinge{0.0, -0.02, 0.22};
    return RigidTransform::translation(p_A_hinge - forward_m * Vec3::UnitY())
           * RigidTransform{rotationFromVector(opening.si * Vec3::UnitX()), Vec3::Zero()}
           * RigidTransform::translation(-p_A_hinge);
}

const Vec3 kIncisors{0.0, -0.103, 0.175};

double openingOf(const RigidTransform& X_AJ) { return (X_AJ * kIncisors - kIncisors).norm(); }

} // namespace

/// How far events let a mouth open.
class TestMouthOpening : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isNotLimitedWithoutTrismus()
    {
        QVERIFY(!mostMouthOpening({}, 1.0));
        QVERIFY(!mostMouthOpening({{AirwayEventKind::TongueOedema, 1.0}}, 1.0));
        QVERIFY(!mostMouthOpening({{AirwayEventKind::Trismus, 0.0}}, 1.0));
        QVERIFY(!mostMouthOpening({{AirwayEventKind::Trismus, 1.0}}, 0.0)); // no patient
    }

    // From the mean of grown people to 10 mm, evenly; a smaller patient's is smaller.
    void becomesLessWithTheSeverity()
    {
        const auto most_mm = [](double severity, double size) {
            return inMillimetres(*mostMouthOpening({{AirwayEventKind::Trismus, severity}}, size));
        };
        QVERIFY(std::abs(most_mm(1.0, 1.0) - 10.0) < 1e-9);
        QVERIFY(std::abs(most_mm(0.5, 1.0) - 30.0) < 1e-9);
        QVERIFY(std::abs(most_mm(1e-6, 1.0) - 50.0) < 1e-3);
        QVERIFY(std::abs(most_mm(1.0, 0.8) - 8.0) < 1e-9);
    }

    void leavesAJawThatIsOpenLess()
    {
        const RigidTransform X_AJ = openJaw(degrees(4.0), 0.001);
        QVERIFY(openingOf(X_AJ) < 0.01);
        const RigidTransform within = withinOpening(X_AJ, kIncisors, millimetres(10.0));
        QCOMPARE((within * kIncisors - X_AJ * kIncisors).norm(), 0.0);
    }

    // It stops on the straight way of the incisors, turned by the same share.
    void stopsAJawWhereTheMouthOpensNoFarther()
    {
        const RigidTransform X_AJ = openJaw(degrees(20.0), 0.006);
        const RigidTransform within = withinOpening(X_AJ, kIncisors, millimetres(10.0));
        QVERIFY(std::abs(openingOf(within) - 0.010) < kSmall_m);
        const double share = 0.010 / openingOf(X_AJ);
        const Vec3 way = within * kIncisors - kIncisors;
        QVERIFY((way - share * (X_AJ * kIncisors - kIncisors)).norm() < kSmall_m);
        const double turn = within.rotation().angularDistance(Quat::Identity());
        QVERIFY(std::abs(turn - share * degrees(20.0).si) < 1e-9);
    }
};

CARINA_TEST(TestMouthOpening)

} // namespace carina::mouth_opening_test

#include "tst_mouth_opening.moc"
