#include "engine/registration/error/error_quadric.h"

#include "engine/registration/error/target_error.h"
#include "tests/engine/geometry/fit/registration_trials.h"
#include "tests/support/test_class.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace carina::error_quadric_test
{
namespace
{

constexpr int kTrials = 40'000;
constexpr double kAgree = 0.02; ///< of the mean square: three deviations of so many trials
constexpr double kSame = 1e-12; ///< relative

double squaredAt(const Mat4& quadric, const Vec3& p)
{
    return p.homogeneous().dot(quadric * p.homogeneous());
}

/// Turns of some milliradians and shifts of some millimetres, all of them correlated.
Mat6 someCovariance(test::Hand& hand)
{
    Mat6 factor;
    for (int i = 0; i < 36; ++i)
        factor(i / 6, i % 6) = hand.unit().x();
    Vec6 sizes;
    sizes << 2e-3, 4e-3, 8e-3, 1e-3, 5e-4, 2e-3;
    factor = sizes.asDiagonal() * factor;
    return factor * factor.transpose() / 6.0;
}

/// Fits of another hand: what each does to a place, without the engine's formulas.
double squaredErrorOfFits(test::Hand& hand, const std::vector<Vec3>& landmarks, double fle,
                          const Vec3& target)
{
    double sum = 0.0;
    for (int trial = 0; trial < kTrials; ++trial) {
        std::vector<Vec3> touched;
        for (const Vec3& landmark : landmarks)
            touched.push_back(landmark + fle / std::sqrt(3.0) * hand.unit());
        sum += (test::hornFit(landmarks, touched) * target - target).squaredNorm();
    }
    return sum / kTrials;
}

} // namespace

class TestErrorQuadric : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isTheMeanOverDrawnMotions();
    void isTheMeanOverFits_data();
    void isTheMeanOverFits();
    void isTheTraceOfThePointCovariance();
    void isWorkedOutByHand_data();
    void isWorkedOutByHand();
    void isLeastAtOnePlace();
};

/// Of motions drawn with the covariance and carried out by the cross product.
void TestErrorQuadric::isTheMeanOverDrawnMotions()
{
    test::Hand hand{5};
    const Mat6 covariance = someCovariance(hand);
    const Mat6 factor = covariance.llt().matrixL();
    const Mat4 quadric = errorQuadric(covariance);
    for (const Vec3& p : test::kTargets) {
        double mean = 0.0;
        for (int i = 0; i < kTrials; ++i) {
            Vec6 unit;
            unit << hand.unit(), hand.unit();
            const Vec6 motion = factor * unit;
            mean += (motion.head<3>().cross(p) + motion.tail<3>()).squaredNorm() / kTrials;
        }
        QVERIFY(std::abs(squaredAt(quadric, p) - mean) < kAgree * mean);
    }
}

void TestErrorQuadric::isTheMeanOverFits_data()
{
    QTest::addColumn<int>("landmarks");
    QTest::newRow("rib cage") << 4;
    QTest::newRow("rib cage and jaw") << 8;
}

void TestErrorQuadric::isTheMeanOverFits()
{
    QFETCH(const int, landmarks);
    constexpr double kFle = 1e-3;
    test::Hand hand{7};
    const std::vector<Vec3> places = test::firstLandmarks(landmarks);
    const auto covariance = fitCovariance(equalErrors(places, metres(kFle)));
    QVERIFY(covariance.has_value());
    const Mat4 quadric = errorQuadric(*covariance);
    for (const Vec3& target : {test::kTargets[0], test::kTargets[3]}) {
        const double mean = squaredErrorOfFits(hand, places, kFle, target);
        QVERIFY(std::abs(squaredAt(quadric, target) - mean) < kAgree * mean);
    }
}

void TestErrorQuadric::isTheTraceOfThePointCovariance()
{
    test::Hand hand{11};
    for (int trial = 0; trial < 100; ++trial) {
        const Mat6 covariance = someCovariance(hand);
        const Mat4 quadric = errorQuadric(covariance);
        QCOMPARE(quadric, Mat4{quadric.transpose()});
        const Vec3 p = 0.3 * hand.unit();
        const double trace = pointCovariance(covariance, p).trace();
        QVERIFY(std::abs(squaredAt(quadric, p) - trace) < kSame * trace);
    }
}

void TestErrorQuadric::isWorkedOutByHand_data()
{
    QTest::addColumn<Mat6>("covariance");
    QTest::addColumn<double>("squared"); // at (3, 2, 7)
    const auto with = [](int row, int column, double value) {
        Mat6 covariance = Mat6::Zero();
        covariance(row, column) = covariance(column, row) = value;
        return covariance;
    };
    QTest::newRow("nothing") << Mat6{Mat6::Zero()} << 0.0;
    QTest::newRow("shifts along x and z")
        << Mat6{with(3, 3, 4.0) + with(5, 5, 1.0)} << 5.0;     // the same everywhere
    QTest::newRow("turns about z") << with(2, 2, 1.0) << 13.0; // the distance from z, squared
    QTest::newRow("turns about x with those about y")
        << with(0, 1, 1.0) << -12.0; // 2 E[w_x w_y] times -xy
    // Of w = a e_z and v = a e_x, E[a^2] = 1: |(-a y, a x, 0) + (a, 0, 0)|^2.
    QTest::newRow("turns about z that shift along x")
        << Mat6{with(2, 2, 1.0) + with(3, 3, 1.0) + with(2, 3, 1.0)} << 10.0;
    // w = a e_x and v = a e_y: (0, a - a z, a y).
    QTest::newRow("turns about x that shift along y")
        << Mat6{with(0, 0, 1.0) + with(4, 4, 1.0) + with(0, 4, 1.0)} << 40.0;
    // w = a e_y and v = a e_z: (a z, 0, a - a x).
    QTest::newRow("turns about y that shift along z")
        << Mat6{with(1, 1, 1.0) + with(5, 5, 1.0) + with(1, 5, 1.0)} << 53.0;
}

void TestErrorQuadric::isWorkedOutByHand()
{
    QFETCH(const Mat6, covariance);
    QFETCH(const double, squared);
    QVERIFY(std::abs(squaredAt(errorQuadric(covariance), {3.0, 2.0, 7.0}) - squared) < 1e-12);
}

/// Equal errors: least at the landmarks' centroid, FLE^2 / N (Fitzpatrick, West, Maurer 1998).
void TestErrorQuadric::isLeastAtOnePlace()
{
    const std::vector<Vec3> places = test::firstLandmarks(6);
    Vec3 centroid = Vec3::Zero();
    for (const Vec3& place : places)
        centroid += place / 6.0;
    const auto covariance = fitCovariance(equalErrors(places, millimetres(1.0)));
    QVERIFY(covariance.has_value());
    const Mat4 quadric = errorQuadric(*covariance);
    QVERIFY(std::abs(squaredAt(quadric, centroid) - 1e-6 / 6.0) < 1e-12 * 1e-6);
    const Vec3 slope = quadric.topRows<3>() * centroid.homogeneous();
    QVERIFY(slope.norm() < 1e-15);
    const Eigen::SelfAdjointEigenSolver<Mat3> curvature{Mat3{quadric.topLeftCorner<3, 3>()}};
    QVERIFY(curvature.eigenvalues().minCoeff() > 0.0);
}

CARINA_TEST(TestErrorQuadric)

} // namespace carina::error_quadric_test

#include "tst_error_quadric.moc"
