#include "engine/geometry/fit/motion_covariance.h"

#include "tests/engine/geometry/fit/registration_trials.h"
#include "tests/support/test_class.h"

#include <Eigen/Cholesky>

namespace carina::motion_covariance_test
{
namespace
{

constexpr int kTrials = 20'000;
constexpr double kAgree = 0.03; // of the whole variance

Mat6 someCovariance(test::Hand& hand, double turns, double shifts)
{
    Mat6 factor;
    for (int i = 0; i < 36; ++i)
        factor(i / 6, i % 6) = hand.unit().x();
    Vec6 sizes;
    sizes << turns, turns, turns, shifts, shifts, shifts;
    factor = sizes.asDiagonal() * factor;
    return factor * factor.transpose() / 6.0;
}

/// A motion of the points that is as likely as its covariance says.
RigidTransform drawn(test::Hand& hand, const Mat6& covariance)
{
    Vec6 unit;
    unit << hand.unit(), hand.unit();
    const Mat6 factor = covariance.llt().matrixL();
    const Vec6 motion = factor * unit;
    return {rotationFromVector(motion.head<3>()), motion.tail<3>()};
}

bool alike(const Mat3& predicted, const Mat3& measured)
{
    return (predicted - measured).cwiseAbs().maxCoeff() < kAgree * measured.trace();
}

} // namespace

class TestMotionCovariance : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// The covariance of a point is that of many points that were moved.
    void movesAPointAsManyDrawnMotionsDo()
    {
        test::Hand hand{37};
        const Mat6 covariance = someCovariance(hand, 2e-3, 1e-3);
        const Vec3 p_FQ{0.2, 0.3, -0.1};
        Mat3 measured = Mat3::Zero();
        for (int i = 0; i < kTrials; ++i) {
            const Vec3 error = drawn(hand, covariance) * p_FQ - p_FQ;
            measured += error * error.transpose() / kTrials;
        }
        QVERIFY(alike(pointCovariance(covariance, p_FQ), measured));
    }

    /// A turn by s about z alone moves a point at (x, y, z) by s (-y, x, 0).
    void leversATurn()
    {
        Mat6 covariance = Mat6::Zero();
        covariance(2, 2) = 1e-4;
        Mat3 expected;
        expected << 4.0, -6.0, 0.0, -6.0, 9.0, 0.0, 0.0, 0.0, 0.0;
        QVERIFY((pointCovariance(covariance, {3.0, 2.0, 7.0}) - 1e-4 * expected).norm() < 1e-15);
    }

    void addsWhatShifts()
    {
        Mat6 covariance = Mat6::Zero();
        covariance.diagonal() << 0, 0, 0, 1e-6, 2e-6, 3e-6;
        const Mat3 expected = Vec3{1e-6, 2e-6, 3e-6}.asDiagonal();
        QVERIFY((pointCovariance(covariance, {0.1, 0.2, 0.3}) - expected).norm() < 1e-15);
    }

    void knowsWhatNoErrorHas()
    {
        Mat3 covariance = Mat3::Identity();
        covariance(0, 1) = covariance(1, 0) = 0.99;
        QVERIFY(isCovariance(covariance));
        covariance(0, 1) = covariance(1, 0) = 1.01; // correlated by more than one
        QVERIFY(!isCovariance(covariance));
        QVERIFY(isCovariance(Mat6::Zero()));
        Mat6 rounded = 1e-6 * Mat6::Identity();
        rounded(5, 5) = -1e-18;
        QVERIFY(isCovariance(rounded));
        rounded(5, 5) = -1e-9;
        QVERIFY(!isCovariance(rounded));
    }

    void crossesVectors()
    {
        const Vec3 a{1.0, -2.0, 3.0};
        const Vec3 b{0.5, 4.0, -1.0};
        QCOMPARE(crossMatrix(a) * b, a.cross(b));
    }
};

CARINA_TEST(TestMotionCovariance)

} // namespace carina::motion_covariance_test

#include "tst_motion_covariance.moc"
