#include "engine/scoring/motion/motion_meter.h"

#include "tests/engine/scoring/motion/measured_motion.h"
#include "tests/support/test_class.h"

#include <numbers>
#include <random>

namespace carina::motion_meter_test
{
namespace
{

using namespace carina::test;

constexpr double kPi = std::numbers::pi;
constexpr double kWindow_s = 0.4;
constexpr double kRadius = 0.1;      ///< m
constexpr double kTurns = 3.0;       ///< measured, of a circle
constexpr double kTurn_s = 4.0;      ///< of a circle
constexpr double kPathError = 2e-3;  ///< m
constexpr double kSmoothing = 0.012; ///< share that the window takes from a circle's derivatives
const Vec3 kUp = Vec3::UnitY();

bool isNear(double value, double truth, double tolerance)
{
    return std::abs(value - truth) <= tolerance;
}

Vec3 onCircle(double t)
{
    const double angle = 2.0 * kPi * t / kTurn_s;
    return kRadius * Vec3{std::cos(angle), std::sin(angle), 0.0};
}

/// Of which kTurns are measured: half a window is lost at either end.
MotionFigures figuresOfCircle(const IsLost& isLost = [](int) { return false; })
{
    MotionMeter meter{kUp};
    addMotion(meter, 0.0, kTurns * kTurn_s + kWindow_s, onCircle, isLost);
    return meter.figures().value();
}

/// From 0 to 1 in the time 0 to 1 with the least jerk (Flash and Hogan 1985).
double leastJerk(double t) { return t * t * t * (10.0 + t * (-15.0 + 6.0 * t)); }

} // namespace

class TestMotionMeter : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void measuresTheWayRoundACircle();
    void measuresTheDerivativesOnACircle();
    void leavesOfASineWhatItSays_data();
    void leavesOfASineWhatItSays();
    void measuresNoPathAtRest();
    void bridgesSamplesThatAreLost();
    void takesNoGapForAMotion();
    void connectsNothingAcrossAPause();
    void knowsTheSmoothnessOfLeastJerk();
    void isRougherWhereTheHandTrembles();
    void saysNothingWhereMostWasLost();
    void saysNothingOfASecond();
};

void TestMotionMeter::measuresTheWayRoundACircle()
{
    const MotionFigures figures = figuresOfCircle();
    QVERIFY(isNear(toSeconds(figures.measured), kTurns * kTurn_s, 1e-6));
    QVERIFY(isNear(toSeconds(figures.watched), kTurns * kTurn_s + kWindow_s, 1e-6));
    QVERIFY(isNear(figures.path.si, kTurns * 2.0 * kPi * kRadius, kPathError));
    QVERIFY(isNear(figures.verticalTravel.si, kTurns * 4.0 * kRadius, kPathError));
}

void TestMotionMeter::measuresTheDerivativesOnACircle()
{
    const MotionFigures figures = figuresOfCircle();
    const double w = 2.0 * kPi / kTurn_s;
    QVERIFY(isNear(figures.meanAcceleration / (kRadius * w * w), 1.0, kSmoothing));
    QVERIFY(isNear(figures.meanJerk / (kRadius * w * w * w), 1.0, kSmoothing));
}

/// The share of amplitude that least squares by a cubic over 25 points at 60 Hz leave, summed by
/// hand.
void TestMotionMeter::leavesOfASineWhatItSays_data()
{
    QTest::addColumn<double>("frequency_Hz");
    QTest::addColumn<double>("ofAcceleration");
    QTest::addColumn<double>("ofJerk");
    QTest::newRow("0.5 Hz") << 0.5 << 0.970 << 0.977;
    QTest::newRow("1 Hz") << 1.0 << 0.884 << 0.909;
    QTest::newRow("2 Hz") << 2.0 << 0.597 << 0.677;
}

void TestMotionMeter::leavesOfASineWhatItSays()
{
    QFETCH(const double, frequency_Hz);
    QFETCH(const double, ofAcceleration);
    QFETCH(const double, ofJerk);
    constexpr double kAmplitude = 0.05;  // m
    constexpr double kShareError = 0.01; // samples do not hit every peak of the sine
    const double w = 2.0 * kPi * frequency_Hz;
    MotionMeter meter{kUp};
    addMotion(meter, 0.0, 10.0 + kWindow_s,
              [w](double t) -> Vec3 { return kAmplitude * std::sin(w * t) * Vec3::UnitX(); });
    const MotionFigures figures = meter.figures().value();
    const double mean = 2.0 / kPi * kAmplitude * w * w; // of the magnitude of a sine
    QVERIFY(isNear(figures.meanAcceleration / mean, ofAcceleration, kShareError));
    QVERIFY(isNear(figures.meanJerk / (mean * w), ofJerk, kShareError));
}

void TestMotionMeter::measuresNoPathAtRest()
{
    std::mt19937 random{3};
    std::normal_distribution<double> noise{0.0, 0.35e-3}; // m, of a tracker
    MotionMeter meter{kUp};
    addMotion(meter, 0.0, 60.0, [&](double) {
        return Vec3{noise(random), noise(random), noise(random)};
    });
    const MotionFigures figures = meter.figures().value();
    QCOMPARE(figures.path.si, 0.0);
    QCOMPARE(figures.verticalTravel.si, 0.0);
    QVERIFY(!figures.smoothness);
    // The mean length of three normal numbers is 1.596 times their deviation.
    QVERIFY(isNear(figures.meanJerk / (1.596 * 0.311), 1.0, 0.1));
    QVERIFY(isNear(figures.meanAcceleration / (1.596 * 0.0109), 1.0, 0.1));
}

void TestMotionMeter::bridgesSamplesThatAreLost()
{
    std::mt19937 random{5};
    std::bernoulli_distribution lost{0.02};
    const MotionFigures whole = figuresOfCircle();
    // The last sample is kept, so that as much is measured.
    const MotionFigures holed =
        figuresOfCircle([&](int i) { return i > 0 && i < 744 && lost(random); });
    QVERIFY(isNear(holed.path.si, whole.path.si, kPathError));
    QVERIFY(isNear(holed.meanAcceleration / whole.meanAcceleration, 1.0, 0.01));
    QVERIFY(isNear(holed.meanJerk / whole.meanJerk, 1.0, 0.01));
    QVERIFY(isNear(toSeconds(holed.measured), toSeconds(whole.measured), 0.1));
}

/// A steady motion, of which half a second in the middle was not seen.
void TestMotionMeter::takesNoGapForAMotion()
{
    constexpr double kSpeed = 0.2; // m/s
    MotionMeter meter{kUp};
    addMotion(
        meter, 0.0, 10.0, [](double t) -> Vec3 { return kSpeed * t * Vec3::UnitX(); },
        [](int i) { return i > 300 && i < 330; });
    const MotionFigures figures = meter.figures().value();
    QVERIFY(figures.meanJerk < 1e-6);
    QVERIFY(figures.meanAcceleration < 1e-6);
    QVERIFY(isNear(figures.path.si, kSpeed * (10.0 - kWindow_s), kSpeed * 0.02));
    QVERIFY(isNear(toSeconds(figures.measured), 10.0 - 0.5 - 2.0 * kWindow_s, 0.02));
}

void TestMotionMeter::connectsNothingAcrossAPause()
{
    MotionMeter meter{kUp};
    const auto still = [](double) -> Vec3 { return Vec3::Zero(); };
    const auto elsewhere = [](double) -> Vec3 { return Vec3::Ones(); };
    addMotion(meter, 0.0, 2.0, still);
    meter.pause();
    addMotion(meter, 30.0, 32.0, elsewhere);
    const MotionFigures figures = meter.figures().value();
    QCOMPARE(figures.path.si, 0.0);
    QVERIFY(isNear(toSeconds(figures.watched), 4.0, 1e-6));
}

/// One movement of 0.3 m in 4 s. Without its ends the formula gives, with s from 0.05 to 0.95,
/// T = 3.6 s, v = 1.875 * 0.3 / 4 m/s and jerk = 0.3 / 4^3 * 60 (1 - 6 s + 6 s^2).
void TestMotionMeter::knowsTheSmoothnessOfLeastJerk()
{
    MotionMeter meter{kUp};
    addMotion(meter, 0.0, 4.0,
              [](double t) -> Vec3 { return 0.3 * leastJerk(t / 4.0) * Vec3::UnitX(); });
    double squared = 0.0;
    constexpr int kSteps = 9000;
    for (int i = 0; i < kSteps; ++i) {
        const double s = 0.05 + 0.9 * (i + 0.5) / kSteps;
        const double jerk = 0.3 / 64.0 * 60.0 * (1.0 - 6.0 * s + 6.0 * s * s);
        squared += jerk * jerk * 3.6 / kSteps;
    }
    const double speed = 1.875 * 0.3 / 4.0;
    const double truth = -std::log(std::pow(3.6, 3) * squared / (speed * speed));
    QVERIFY(isNear(meter.figures()->smoothness.value(), truth, 0.05));
}

void TestMotionMeter::isRougherWhereTheHandTrembles()
{
    const auto smoothness = [](double tremor) {
        MotionMeter meter{kUp};
        addMotion(meter, 0.0, 4.0, [tremor](double t) -> Vec3 {
            return (0.3 * leastJerk(t / 4.0) + tremor * std::sin(2.0 * kPi * 2.0 * t))
                   * Vec3::UnitX();
        });
        return meter.figures()->smoothness.value();
    };
    QVERIFY(smoothness(0.005) < smoothness(0.0) - 1.0);
}

void TestMotionMeter::saysNothingWhereMostWasLost()
{
    MotionMeter meter{kUp};
    addMotion(meter, 0.0, 10.0, onCircle, [](int i) { return i > 240; });
    QVERIFY(!meter.figures());
}

void TestMotionMeter::saysNothingOfASecond()
{
    MotionMeter meter{kUp};
    QVERIFY(!meter.figures());
    addMotion(meter, 0.0, 1.0, onCircle);
    QVERIFY(!meter.figures());
}

CARINA_TEST(TestMotionMeter)

} // namespace carina::motion_meter_test

#include "tst_motion_meter.moc"
