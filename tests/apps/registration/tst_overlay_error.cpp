#include "apps/registration/overlay_error.h"
#include "tests/support/test_class.h"

#include <cmath>

namespace carina::overlay_error_test
{

class TestOverlayError : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isZeroForThePerfectRegistration();
    void isTheShiftOfAShiftedRegistration();
    void growsWithTheDistanceFromTheAxisOfATurn();
};

namespace
{

constexpr double kTolerance = 1e-12; ///< metres

const RigidTransform kX_TA{Quat{0.8, 0.6, 0.0, 0.0}, Vec3{0.1, -0.2, -1.3}};

} // namespace

void TestOverlayError::isZeroForThePerfectRegistration()
{
    QVERIFY(overlayError(kX_TA.inverse(), kX_TA, {0.1, 0.2, 0.3}) < kTolerance);
}

void TestOverlayError::isTheShiftOfAShiftedRegistration()
{
    const RigidTransform X_AT =
        RigidTransform::translation({0.002, -0.003, 0.006}) * kX_TA.inverse();
    QVERIFY(std::abs(overlayError(X_AT, kX_TA, {0.1, 0.2, 0.3}) - 0.007) < kTolerance);
}

void TestOverlayError::growsWithTheDistanceFromTheAxisOfATurn()
{
    // Turned by 60 degrees about z of A: the chord is as long as the radius.
    const RigidTransform turn{Quat{std::sqrt(0.75), 0.0, 0.0, 0.5}, Vec3::Zero()};
    const RigidTransform X_AT = turn * kX_TA.inverse();
    QVERIFY(std::abs(overlayError(X_AT, kX_TA, {0.03, 0.04, 0.5}) - 0.05) < kTolerance);
    QVERIFY(overlayError(X_AT, kX_TA, {0.0, 0.0, 0.5}) < kTolerance);
}

CARINA_TEST(TestOverlayError)

} // namespace carina::overlay_error_test

#include "tst_overlay_error.moc"
