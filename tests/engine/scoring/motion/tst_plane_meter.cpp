#include "engine/scoring/motion/plane_meter.h"

#include "tests/engine/scoring/motion/measured_motion.h"
#include "tests/support/test_class.h"

#include <numbers>

namespace carina::plane_meter_test
{
namespace
{

using namespace carina::test;

constexpr double kRounding_deg2 = 0.05; ///< samples at 60 Hz instead of an integral
const Vec3 kUp = Vec3::UnitY();         ///< L's y axis: a handle held upright

double inSquareDegrees(double squareRadians)
{
    return squareRadians * inDegrees(radians(1.0)) * inDegrees(radians(1.0));
}

PoseSample held(double seconds, const Quat& rotation)
{
    PoseSample sample;
    sample.time = atSeconds(seconds);
    sample.X_FO = {rotation, Vec3::Zero()};
    return sample;
}

Quat about(const Vec3& axis, Angle angle) { return Quat{Eigen::AngleAxisd{angle.si, axis}}; }

/// Ten seconds of a plane that leans to its side by this angle, about L's own z axis.
PlaneFigures figuresOf(const std::function<Angle(double)>& lean, const Quat& before)
{
    PlaneMeter meter{kUp};
    for (int i = 0; i <= 600; ++i) {
        const double t = i / kRate_Hz;
        meter.add(held(t, before * about(Vec3::UnitZ(), lean(t))));
    }
    return meter.figures().value();
}

Angle wobble(double t) { return degrees(10.0 * std::sin(2.0 * std::numbers::pi * t)); }

} // namespace

class TestPlaneMeter : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void measuresAWobbleAsHalfItsSquare();
    void tellsALeanFromAWobble();
    void ignoresWhatStaysInThePlane();
    void leavesOutWhatItDidNotSee();
    void saysNothingOfAMoment();
};

void TestPlaneMeter::measuresAWobbleAsHalfItsSquare()
{
    const PlaneFigures figures = figuresOf(wobble, Quat::Identity());
    QVERIFY(std::abs(inSquareDegrees(figures.squaredTilt) - 50.0) < kRounding_deg2);
    QVERIFY(std::abs(inSquareDegrees(figures.variance) - 50.0) < kRounding_deg2);
    QVERIFY(std::abs(inDegrees(figures.tilt)) < 0.01);
}

/// About 5 degrees: 5^2 + 10^2 / 2 from the vertical, 10^2 / 2 about the mean.
void TestPlaneMeter::tellsALeanFromAWobble()
{
    const PlaneFigures figures =
        figuresOf([](double t) { return degrees(5.0) + wobble(t); }, Quat::Identity());
    QVERIFY(std::abs(inSquareDegrees(figures.squaredTilt) - 75.0) < kRounding_deg2);
    QVERIFY(std::abs(inSquareDegrees(figures.variance) - 50.0) < kRounding_deg2);
    QVERIFY(std::abs(inDegrees(figures.tilt) - 5.0) < 0.01);
}

/// The handle's inclination, and where at the patient the person stands.
void TestPlaneMeter::ignoresWhatStaysInThePlane()
{
    PlaneMeter meter{kUp};
    for (int i = 0; i <= 600; ++i) {
        const double t = i / kRate_Hz;
        meter.add(held(t, about(kUp, degrees(20.0 * t)) * about(Vec3::UnitX(), wobble(t))));
    }
    QVERIFY(inSquareDegrees(meter.figures()->squaredTilt) < 1e-6);
    const PlaneFigures figures = figuresOf(wobble, about(kUp, degrees(77.0)));
    QVERIFY(std::abs(inSquareDegrees(figures.squaredTilt) - 50.0) < kRounding_deg2);
}

void TestPlaneMeter::leavesOutWhatItDidNotSee()
{
    PlaneMeter meter{kUp};
    for (int i = 0; i <= 60; ++i)
        meter.add(held(i / kRate_Hz, Quat::Identity()));
    PoseSample lost = held(1.1, about(Vec3::UnitZ(), degrees(45.0)));
    lost.validity = Validity::Lost;
    meter.add(lost);
    for (int i = 0; i <= 60; ++i)
        meter.add(held(5.0 + i / kRate_Hz, Quat::Identity()));
    const PlaneFigures figures = meter.figures().value();
    QCOMPARE(figures.squaredTilt, 0.0);
    QVERIFY(std::abs(toSeconds(figures.measured) - 2.0) < 1e-6);
}

void TestPlaneMeter::saysNothingOfAMoment()
{
    PlaneMeter meter{kUp};
    meter.add(held(0.0, Quat::Identity()));
    meter.add(held(0.1, Quat::Identity()));
    QVERIFY(!meter.figures());
}

CARINA_TEST(TestPlaneMeter)

} // namespace carina::plane_meter_test

#include "tst_plane_meter.moc"
