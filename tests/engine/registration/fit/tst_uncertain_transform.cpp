#include "engine/registration/fit/uncertain_transform.h"

#include "tests/engine/registration/error/registration_trials.h"
#include "tests/support/test_class.h"

#include <Eigen/Cholesky>

namespace carina::uncertain_transform_test
{
namespace
{

constexpr int kTrials = 20'000;
constexpr double kAgree = 0.03; // of the whole variance

using Vec6 = Eigen::Matrix<double, 6, 1>;

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

UncertainTransform somewhere(test::Hand& hand)
{
    return {hand.pose(), someCovariance(hand, 2e-3, 1e-3)};
}

/// A pose that may be the true one where the known one is uncertain.
RigidTransform drawn(test::Hand& hand, const UncertainTransform& X_FO)
{
    Vec6 unit;
    unit << hand.unit(), hand.unit();
    const Mat6 factor = X_FO.covariance_F.llt().matrixL();
    const Vec6 motion = factor * unit;
    return RigidTransform{rotationFromVector(motion.head<3>()), motion.tail<3>()} * X_FO.X_FO;
}

bool alike(const Mat3& predicted, const Mat3& measured)
{
    return (predicted - measured).cwiseAbs().maxCoeff() < kAgree * measured.trace();
}

bool same(const Mat6& a, const Mat6& b) { return (a - b).norm() < 1e-9 * b.norm(); }

} // namespace

class TestUncertainTransform : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// Tracker, stylus and tip: the covariance of the chain is that of many drawn chains.
    void composesAlongAChain()
    {
        test::Hand hand{37};
        const UncertainTransform X_AT = somewhere(hand);
        const UncertainTransform X_TS = somewhere(hand);
        const Vec3 p_SQ{0.01, -0.02, 0.15};
        const Mat3 tip = 1e-6 * test::ellipsoid({0.5, 1.0, 2.0}, {0.3, 0.2, 0.1});
        const UncertainTransform X_AS = X_AT * X_TS;
        const Vec3 p_AQ = X_AS.X_FO * p_SQ;
        QVERIFY((p_AQ - X_AT.X_FO * (X_TS.X_FO * p_SQ)).norm() < 1e-12);
        Mat3 measured = Mat3::Zero();
        for (int i = 0; i < kTrials; ++i) {
            const Vec3 p_S = p_SQ + hand.error(test::factorOf(tip));
            const Vec3 error = drawn(hand, X_AT) * (drawn(hand, X_TS) * p_S) - p_AQ;
            measured += error * error.transpose() / kTrials;
        }
        QVERIFY(alike(pointCovariance(X_AS, p_SQ, tip), measured));
    }

    void inverts()
    {
        test::Hand hand{41};
        const UncertainTransform X_FO = somewhere(hand);
        const UncertainTransform X_OF = inverse(X_FO);
        const Vec3 p_FQ{0.2, 0.3, -0.1};
        const Vec3 p_OQ = X_OF.X_FO * p_FQ;
        Mat3 measured = Mat3::Zero();
        for (int i = 0; i < kTrials; ++i) {
            const Vec3 error = drawn(hand, X_FO).inverse() * p_FQ - p_OQ;
            measured += error * error.transpose() / kTrials;
        }
        QVERIFY(alike(pointCovariance(X_OF.covariance_F, p_OQ), measured));
        QVERIFY(same(inverse(X_OF).covariance_F, X_FO.covariance_F));
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
        UncertainTransform X_FO{{rotationFromVector({0.0, 0.0, 1.5707963267948966}), {1, 2, 3}},
                                covariance};
        const Mat3 point = Vec3{4e-6, 5e-6, 6e-6}.asDiagonal(); // x goes to y, y to -x
        const Mat3 expected = Vec3{6e-6, 6e-6, 9e-6}.asDiagonal();
        QVERIFY((pointCovariance(X_FO, {0.1, 0.2, 0.3}, point) - expected).norm() < 1e-15);
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

CARINA_TEST(TestUncertainTransform)

} // namespace carina::uncertain_transform_test

#include "tst_uncertain_transform.moc"
