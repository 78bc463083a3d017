#include "engine/geometry/rigid_transform.h"
#include "engine/geometry/rotation.h"
#include "tests/support/test_class.h"

#include <limits>
#include <random>

namespace carina::rigid_transform_test
{
namespace
{

constexpr double kTolerance = 1e-12; // m and rad, for coordinates of about one

RigidTransform someTransform(std::mt19937& random)
{
    std::normal_distribution<double> part;
    const Vec3 turn{part(random), part(random), part(random)};
    return {rotationFromVector(turn), {part(random), part(random), part(random)}};
}

Mat4 matrixWith(const Mat3& turn, const Vec3& place)
{
    Mat4 m = Mat4::Identity();
    m.topLeftCorner<3, 3>() = turn;
    m.topRightCorner<3, 1>() = place;
    return m;
}

bool near(const RigidTransform& a, const RigidTransform& b)
{
    return (a.translation() - b.translation()).norm() < kTolerance
           && angleBetween(a.rotation(), b.rotation()).si < kTolerance;
}

} // namespace

/// The truth is multiplication of 4x4 matrices.
class RigidTransformTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isTheIdentityByDefault() { QCOMPARE(RigidTransform{}.matrix(), Mat4::Identity().eval()); }

    void bringsItsQuaternionToUnitLengthAndTheUpperHalf()
    {
        const RigidTransform X_AB{Quat{-6.0, 0.0, 8.0, 0.0}, Vec3::Zero()};
        QVERIFY((X_AB.rotation().coeffs() - Quat{0.6, 0.0, -0.8, 0.0}.coeffs()).norm() < 1e-15);
    }

    void takesPointsAsItsMatrixDoes()
    {
        std::mt19937 random{7};
        for (int i = 0; i < 100; ++i) {
            const RigidTransform X_AB = someTransform(random);
            const Vec3 p_BQ = someTransform(random).translation();
            const Vec3 expected = (X_AB.matrix() * p_BQ.homogeneous()).head<3>();
            QVERIFY((X_AB * p_BQ - expected).norm() < kTolerance);
        }
    }

    void chainsAsMatricesMultiply()
    {
        std::mt19937 random{8};
        for (int i = 0; i < 100; ++i) {
            const RigidTransform X_AB = someTransform(random);
            const RigidTransform X_BC = someTransform(random);
            const Mat4 expected = X_AB.matrix() * X_BC.matrix();
            QVERIFY(((X_AB * X_BC).matrix() - expected).cwiseAbs().maxCoeff() < kTolerance);
        }
    }

    void hasAnInverse()
    {
        std::mt19937 random{9};
        for (int i = 0; i < 100; ++i) {
            const RigidTransform X_AB = someTransform(random);
            const Mat4 expected = X_AB.matrix().inverse();
            QVERIFY((X_AB.inverse().matrix() - expected).cwiseAbs().maxCoeff() < kTolerance);
        }
    }

    void isReadFromItsMatrix()
    {
        std::mt19937 random{10};
        for (int i = 0; i < 100; ++i) {
            const RigidTransform X_AB = someTransform(random);
            QVERIFY(near(RigidTransform::fromMatrix(X_AB.matrix()).value(), X_AB));
        }
        const RigidTransform moved = RigidTransform::translation({1.0, 2.0, 3.0});
        QCOMPARE(moved.translation(), Vec3(1.0, 2.0, 3.0));
        QCOMPARE(moved.rotation().w(), 1.0);
    }

    void refusesMatricesThatAreNoPose_data()
    {
        QTest::addColumn<Mat4>("matrix");
        QTest::addColumn<Errc>("code");
        const Mat3 none = Mat3::Identity();
        Mat3 sheared = none;
        sheared(0, 1) = 0.01;
        Mat4 withoutLastRow = Mat4::Identity();
        withoutLastRow(3, 3) = 0.0;
        Mat4 projective = Mat4::Identity();
        projective(3, 0) = 0.01;
        Mat4 notANumber = Mat4::Identity();
        notANumber(2, 3) = std::numeric_limits<double>::quiet_NaN();
        Mat4 infinite = Mat4::Identity();
        infinite(0, 0) = std::numeric_limits<double>::infinity();
        const auto place = Vec3::Zero();
        QTest::newRow("scaled") << matrixWith(1.01 * none, place) << Errc::NotARotation;
        QTest::newRow("sheared") << matrixWith(sheared, place) << Errc::NotARotation;
        QTest::newRow("mirrored") << matrixWith(-none, place) << Errc::NotARotation;
        QTest::newRow("zero") << matrixWith(0.0 * none, place) << Errc::NotARotation;
        QTest::newRow("without last row") << withoutLastRow << Errc::NotARotation;
        QTest::newRow("projective") << projective << Errc::NotARotation;
        QTest::newRow("not a number") << notANumber << Errc::NotFinite;
        QTest::newRow("infinite") << infinite << Errc::NotFinite;
    }
    void refusesMatricesThatAreNoPose()
    {
        QFETCH(Mat4, matrix);
        QFETCH(Errc, code);
        const Result<RigidTransform> X_AB = RigidTransform::fromMatrix(matrix);
        QVERIFY(!X_AB);
        QCOMPARE(X_AB.error().code, code);
    }

    void toleratesRoundingUpToItsLimit_data()
    {
        QTest::addColumn<double>("scale");
        QTest::addColumn<double>("tolerance");
        QTest::addColumn<bool>("taken");
        // R^T R - 1 of a scaled rotation is scale^2 - 1.
        QTest::newRow("within the usual limit") << std::sqrt(1.00099) << 1e-3 << true;
        QTest::newRow("beyond it") << std::sqrt(1.00101) << 1e-3 << false;
        QTest::newRow("within a wider one") << std::sqrt(1.0049) << 5e-3 << true;
        QTest::newRow("beyond that") << std::sqrt(1.0051) << 5e-3 << false;
        QTest::newRow("too small") << std::sqrt(0.99899) << 1e-3 << false;
    }
    void toleratesRoundingUpToItsLimit()
    {
        QFETCH(double, scale);
        QFETCH(double, tolerance);
        QFETCH(bool, taken);
        const Mat4 matrix = matrixWith(scale * Mat3::Identity(), Vec3::UnitX());
        const Result<RigidTransform> X_AB = RigidTransform::fromMatrix(matrix, tolerance);
        QCOMPARE(X_AB.has_value(), taken);
        if (taken)
            QVERIFY(std::abs(X_AB->rotation().norm() - 1.0) < kTolerance);
    }

    void interpolatesAlongALineAndAGreatCircle_data()
    {
        QTest::addColumn<double>("share");
        for (const double share : {0.0, 0.25, 0.5, 1.0, 1.5, -0.5})
            QTest::addRow("share %g", share) << share;
    }
    void interpolatesAlongALineAndAGreatCircle()
    {
        QFETCH(double, share);
        const Vec3 turn_F{0.3, -0.5, 0.8};
        const Quat q_F0 = rotationFromVector({1.0, 0.2, -0.4});
        const RigidTransform X_F0{q_F0, {1.0, 0.0, 0.0}};
        const RigidTransform X_F1{rotationFromVector(turn_F) * q_F0, {1.0, 2.0, -4.0}};
        const RigidTransform expected{rotationFromVector(share * turn_F) * q_F0,
                                      {1.0, 2.0 * share, -4.0 * share}};
        QVERIFY(near(interpolate(X_F0, X_F1, share), expected));
    }

    void interpolatesTheShorterWayRound()
    {
        const RigidTransform X_F0{rotationFromVector({0.0, 0.0, 3.0}), Vec3::Zero()};
        const RigidTransform X_F1{rotationFromVector({0.0, 0.0, -3.0}), Vec3::Zero()};
        const Quat middle = interpolate(X_F0, X_F1, 0.5).rotation();
        QVERIFY(angleBetween(middle, Quat{0.0, 0.0, 0.0, 1.0}).si < kTolerance);
    }
};

CARINA_TEST(RigidTransformTest)

} // namespace carina::rigid_transform_test

#include "tst_rigid_transform.moc"
