#include "engine/geometry/rotation.h"
#include "tests/support/test_class.h"

#include <numbers>
#include <random>

namespace carina::rotation_test
{
namespace
{

constexpr double kPi = std::numbers::pi;
constexpr double kTolerance = 1e-14; // rad, or a quaternion's coefficient: rounding of doubles

Quat aboutAxis(double angle, const Vec3& axis)
{
    return Quat{Eigen::AngleAxisd{angle, axis.normalized()}};
}

Quat negative(const Quat& q) { return Quat{Quat::Coefficients{-q.coeffs()}}; }

double greatestDifference(const Quat& a, const Quat& b)
{
    return (a.coeffs() - b.coeffs()).cwiseAbs().maxCoeff();
}

/// Vectors of any direction, of lengths up to `longest`.
std::vector<Vec3> someVectors(double longest)
{
    std::mt19937 random{7};
    std::uniform_real_distribution<double> part{-1.0, 1.0};
    std::uniform_real_distribution<double> length{0.0, longest};
    std::vector<Vec3> vectors;
    for (int i = 0; i < 200; ++i) {
        const Vec3 direction{part(random), part(random), part(random)};
        vectors.push_back(length(random) * direction.normalized());
    }
    return vectors;
}

} // namespace

class RotationTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void knowsTheAngleOfARotation_data()
    {
        QTest::addColumn<double>("angle");
        QTest::newRow("none") << 0.0;
        QTest::newRow("a nanoradian, which acos(w) takes for none") << 1e-9;
        QTest::newRow("a degree") << kPi / 180.0;
        QTest::newRow("a quarter turn") << kPi / 2.0;
        QTest::newRow("just short of half a turn") << kPi - 1e-9;
        QTest::newRow("half a turn") << kPi;
    }
    void knowsTheAngleOfARotation()
    {
        QFETCH(double, angle);
        const Quat q = aboutAxis(angle, {1.0, -2.0, 0.5});
        QVERIFY(std::abs(angleOf(q).si - angle) <= kTolerance * std::max(angle, 1e-6));
        QCOMPARE(angleOf(negative(q)).si, angleOf(q).si);
    }

    void neverGivesMoreThanHalfATurn()
    {
        const Quat q = aboutAxis(1.5 * kPi, Vec3::UnitZ());
        QVERIFY(std::abs(angleOf(q).si - 0.5 * kPi) < kTolerance);
    }

    void knowsTheAngleBetweenTwoViews()
    {
        const Vec3 axis{0.3, 0.4, -1.0};
        const Quat q_s = aboutAxis(0.9, axis) * aboutAxis(0.5, Vec3::UnitX());
        const Quat q_c = aboutAxis(0.2, axis) * aboutAxis(0.5, Vec3::UnitX());
        QVERIFY(std::abs(angleBetween(q_s, q_c).si - 0.7) < kTolerance);
        QVERIFY(angleBetween(q_s, negative(q_s)).si < kTolerance);
    }

    void bringsAQuaternionToUnitLengthAndTheUpperHalf_data()
    {
        QTest::addColumn<Quat>("q");
        QTest::addColumn<Quat>("expected");
        QTest::newRow("as it should be") << Quat{0.6, 0.8, 0.0, 0.0} << Quat{0.6, 0.8, 0.0, 0.0};
        QTest::newRow("too long") << Quat{3.0, 0.0, 4.0, 0.0} << Quat{0.6, 0.0, 0.8, 0.0};
        QTest::newRow("lower half") << Quat{-0.6, 0.0, 0.0, 0.8} << Quat{0.6, 0.0, 0.0, -0.8};
        QTest::newRow("both") << Quat{-6.0, 8.0, 0.0, 0.0} << Quat{0.6, -0.8, 0.0, 0.0};
        QTest::newRow("half a turn") << Quat{0.0, 0.0, -1.0, 0.0} << Quat{0.0, 0.0, -1.0, 0.0};
    }
    void bringsAQuaternionToUnitLengthAndTheUpperHalf()
    {
        QFETCH(Quat, q);
        QFETCH(Quat, expected);
        QVERIFY(greatestDifference(canonical(q), expected) < kTolerance);
    }

    void turnsByTheLengthOfAVectorAboutIt()
    {
        for (const Vec3& v : someVectors(3.0 * kPi)) {
            const Quat expected = aboutAxis(v.norm(), v);
            QVERIFY(greatestDifference(rotationFromVector(v), expected) < kTolerance);
        }
        QCOMPARE(rotationFromVector(Vec3::Zero()).w(), 1.0);
    }

    void givesTheVectorBack()
    {
        for (const Vec3& v : someVectors(kPi - 1e-6)) {
            QVERIFY((rotationVector(rotationFromVector(v)) - v).norm() < 1e-13);
            QVERIFY((rotationVector(negative(rotationFromVector(v))) - v).norm() < 1e-13);
        }
        QCOMPARE(rotationVector(Quat::Identity()), Vec3(0.0, 0.0, 0.0));
    }

    void isExactForTheSmallestTurns_data()
    {
        QTest::addColumn<double>("angle");
        QTest::newRow("on either side of the series, above") << 1.01e-8;
        QTest::newRow("on either side of the series, below") << 0.99e-8;
        QTest::newRow("a picoradian") << 1e-12;
        QTest::newRow("the smallest of all") << 1e-300;
    }
    void isExactForTheSmallestTurns()
    {
        QFETCH(double, angle);
        const Vec3 v = angle * Vec3::UnitY();
        const Quat q = rotationFromVector(v);
        QVERIFY(std::abs(q.y() / (0.5 * angle) - 1.0) < 1e-15);
        QVERIFY((rotationVector(q) - v).norm() <= 1e-15 * angle);
    }
};

CARINA_TEST(RotationTest)

} // namespace carina::rotation_test

#include "tst_rotation.moc"
