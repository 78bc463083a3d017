#include "engine/registration/error/error_bound.h"

#include "engine/geometry/rotation.h"
#include "tests/support/test_class.h"

#include <cmath>

namespace carina::error_bound_test
{
namespace
{

constexpr double kTable = 5e-4; // relative: tables have four digits

Mat3 ellipsoidOf(const Vec3& variances)
{
    const Mat3 axes = rotationFromVector({0.3, -0.8, 0.5}).toRotationMatrix();
    return axes * variances.asDiagonal() * axes.transpose();
}

} // namespace

class TestErrorBound : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void agreesWithTables_data()
    {
        QTest::addColumn<Vec3>("variances");
        QTest::addColumn<double>("degrees");
        QTest::addColumn<double>("share");
        QTest::addColumn<double>("square");
        const double known = kKnownExactly;
        QTest::newRow("normal") << Vec3{1, 0, 0} << known << 0.95 << 1.95996 * 1.95996;
        QTest::newRow("chi-squared of two") << Vec3{0, 1, 1} << known << 0.95 << 5.9915;
        QTest::newRow("chi-squared of three") << Vec3{1, 1, 1} << known << 0.95 << 7.8147;
        QTest::newRow("chi-squared of three, 99 %") << Vec3{1, 1, 1} << known << 0.99 << 11.3449;
        QTest::newRow("chi-squared of three, half") << Vec3{1, 1, 1} << known << 0.5 << 2.3660;
        QTest::newRow("Student's t of 6") << Vec3{0, 0, 1} << 6.0 << 0.95 << 2.4469 * 2.4469;
        QTest::newRow("Student's t of 3") << Vec3{0, 0, 1} << 3.0 << 0.95 << 3.1824 * 3.1824;
        QTest::newRow("Fisher's F of 2 and 10") << Vec3{1, 0, 1} << 10.0 << 0.95 << 2 * 4.1028;
        QTest::newRow("Fisher's F of 3 and 6") << Vec3{1, 1, 1} << 6.0 << 0.95 << 3 * 4.7571;
        QTest::newRow("Fisher's F of 3 and 18") << Vec3{1, 1, 1} << 18.0 << 0.95 << 3 * 3.1599;
        QTest::newRow("Fisher's F of 3 and 18, 99 %")
            << Vec3{1, 1, 1} << 18.0 << 0.99 << 3 * 5.0919;
        // Imhof (1961), table 1, the first form
        QTest::newRow("Imhof at 0.1") << Vec3{0.6, 0.3, 0.1} << known << 1 - 0.9458 << 0.1;
        QTest::newRow("Imhof at 0.7") << Vec3{0.6, 0.3, 0.1} << known << 1 - 0.5064 << 0.7;
        QTest::newRow("Imhof at 2") << Vec3{0.6, 0.3, 0.1} << known << 1 - 0.1240 << 2.0;
    }

    void agreesWithTables()
    {
        QFETCH(Vec3, variances);
        QFETCH(double, degrees);
        QFETCH(double, share);
        QFETCH(double, square);
        const double bound = errorBound(ellipsoidOf(variances), degrees, share).si;
        QVERIFY2(std::abs(bound * bound / square - 1.0) < 2.0 * kTable,
                 qPrintable(QString::number(bound * bound)));
    }

    /// What is added to a flat error of any shape makes it longer; what is longest decides.
    void isContinuousFromLineToBall()
    {
        double before = 1.95;
        for (const double other : {0.0, 1e-6, 1e-3, 0.01, 0.1, 0.5, 0.9, 1.0}) {
            const double bound = errorBound(ellipsoidOf({other, 1.0, other})).si;
            QVERIFY(bound >= before && bound < before + 0.5);
            before = bound;
        }
        QVERIFY(std::abs(before - 2.7955) < kTable);
    }

    void hasTheUnitOfTheError()
    {
        const Mat3 covariance = ellipsoidOf({1.0, 2.0, 3.0});
        const double bound = errorBound(covariance, 9.0).si;
        QVERIFY(std::abs(errorBound(1e-6 * covariance, 9.0).si / (1e-3 * bound) - 1.0) < 1e-6);
    }

    void isNothingForNoError() { QCOMPARE(errorBound(Mat3::Zero()).si, 0.0); }

    void takesNinetyFivePercentUnlessTold()
    {
        const Mat3 covariance = ellipsoidOf({1.0, 2.0, 3.0});
        QCOMPARE(errorBound(covariance).si, errorBound(covariance, kKnownExactly, 0.95).si);
    }

    /// No Gaussian error of a point has a bound of 95 % below that of a ball, 1.614 RMS.
    void isNeverBelowTheBalls()
    {
        const double ball = std::sqrt(7.8147 / 3.0);
        for (double b = 0.0; b <= 1.0; b += 0.1)
            for (double c = 0.0; c <= b; c += 0.1) {
                const double rms = std::sqrt(1.0 + b + c);
                QVERIFY(errorBound(ellipsoidOf({1.0, b, c})).si > (ball - kTable) * rms);
            }
    }

    void knowsChiSquared_data()
    {
        QTest::addColumn<double>("degrees");
        QTest::addColumn<double>("share");
        QTest::addColumn<double>("quantile");
        QTest::newRow("1, 95 %") << 1.0 << 0.95 << 3.8415;
        QTest::newRow("6, 5 %") << 6.0 << 0.05 << 1.6354;
        QTest::newRow("18, 5 %") << 18.0 << 0.05 << 9.3905;
        QTest::newRow("18, 99.9 %") << 18.0 << 0.999 << 42.3124;
        QTest::newRow("100, half") << 100.0 << 0.5 << 99.3341;
    }

    void knowsChiSquared()
    {
        QFETCH(double, degrees);
        QFETCH(double, share);
        QFETCH(double, quantile);
        QVERIFY(std::abs(chiSquaredShare(degrees, share) * degrees / quantile - 1.0) < 1e-4);
        QVERIFY(std::abs(chiSquaredTail(quantile, degrees) / (1.0 - share) - 1.0) < 1e-3);
    }

    void knowsFishersF_data()
    {
        QTest::addColumn<double>("above");
        QTest::addColumn<double>("below");
        QTest::addColumn<double>("quantile");
        QTest::addColumn<double>("tail");
        QTest::newRow("3 and 6, 5 %") << 3.0 << 6.0 << 4.7571 << 0.05;
        QTest::newRow("18 and 18, 5 %") << 18.0 << 18.0 << 2.2172 << 0.05;
        QTest::newRow("18 and 6, 0.5 %") << 18.0 << 6.0 << 9.6644 << 0.005;
        QTest::newRow("6 and 18, 0.5 %") << 6.0 << 18.0 << 4.6627 << 0.005;
    }

    void knowsFishersF()
    {
        QFETCH(double, above);
        QFETCH(double, below);
        QFETCH(double, quantile);
        QFETCH(double, tail);
        QVERIFY(std::abs(varianceRatioTail(quantile, above, below) / tail - 1.0) < 1e-3);
        QVERIFY(std::abs(varianceRatioTail(1.0 / quantile, below, above) - (1.0 - tail)) < 1e-4);
        QCOMPARE(varianceRatioTail(0.0, above, below), 1.0);
    }

    /// Of two degrees it is exp(-x / 2), however far out.
    void knowsSmallChances()
    {
        for (const double x : {0.0, 1.0, 20.0, 60.0, 200.0})
            QVERIFY(std::abs(chiSquaredTail(x, 2.0) / std::exp(-0.5 * x) - 1.0) < 1e-9);
    }
};

CARINA_TEST(TestErrorBound)

} // namespace carina::error_bound_test

#include "tst_error_bound.moc"
