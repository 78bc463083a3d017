#include "engine/anatomy/airway/jaw_reach.h"

#include "engine/geometry/rotation.h"
#include "tests/support/test_class.h"

#include <cmath>
#include <limits>

namespace carina::jaw_reach_test
{
namespace
{

const Vec3 kIncisors{0.0, -0.103, 0.175};
/// Of the reference man, midway between the condyles.
const Vec3 kHinge = kIncisors + Vec3{0.0, 0.087, 0.045};
constexpr double kMan = 1.0;

RigidTransform turned(const Vec3& axis, Angle angle, const Vec3& p_A)
{
    return RigidTransform::translation(p_A)
           * RigidTransform{rotationFromVector(angle.si * axis), Vec3::Zero()}
           * RigidTransform::translation(-p_A);
}

bool isReached(const RigidTransform& X_AJ, double size = kMan)
{
    return isInReachOfJaw(X_AJ, kIncisors, size);
}

} // namespace

/// Which poses of a lower jaw are taken for measured.
class TestJawReach : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void reachesAsFarAsLivingJawsGo()
    {
        QVERIFY(isReached({}));
        // The widest of 32 to 77 mm (Dijkstra et al), by a turn about the condyles.
        const double widest = 2.0 * std::asin(0.5 * 0.077 / (kIncisors - kHinge).norm());
        QVERIFY(isReached(turned(Vec3::UnitX(), radians(widest), kHinge)));
        QVERIFY(isReached(RigidTransform::translation({0.012, -0.015, 0.0})
                          * turned(Vec3::UnitX(), degrees(30.0), kHinge)));
    }

    void reachesNoFartherThanItsBounds()
    {
        const auto down = [](double way) { return RigidTransform::translation({0.0, 0.0, -way}); };
        QVERIFY(isReached(down(0.999 * kFarthestJaw.si)));
        QVERIFY(!isReached(down(1.001 * kFarthestJaw.si)));
        QVERIFY(!isReached(down(0.5)));
        for (const Vec3& axis : {Vec3{Vec3::UnitX()}, Vec3{Vec3::UnitY()}, Vec3{Vec3::UnitZ()}}) {
            QVERIFY(isReached(turned(axis, 0.999 * kMostJawTurn, kIncisors)));
            QVERIFY(!isReached(turned(axis, 1.001 * kMostJawTurn, kIncisors)));
        }
    }

    void reachesLessFarInASmallPatient()
    {
        const auto down = RigidTransform::translation({0.0, 0.0, -0.06});
        QVERIFY(isReached(down));
        QVERIFY(!isReached(down, 0.5));
        QVERIFY(isReached(RigidTransform::translation({0.0, 0.0, -0.04}), 0.5));
    }

    void takesNoNumberForAPose()
    {
        constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
        QVERIFY(!isReached(RigidTransform::translation({0.0, kNone, 0.0})));
        QVERIFY(!isReached({}, kNone));
    }
};

CARINA_TEST(TestJawReach)

} // namespace carina::jaw_reach_test

#include "tst_jaw_reach.moc"
