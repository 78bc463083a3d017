#include "engine/scoring/course/force_meter.h"
#include "engine/scoring/course/oxygen_meter.h"
#include "tests/engine/scoring/course/hand_written_course.h"
#include "tests/support/test_class.h"

namespace carina::patient_meters_test
{
namespace
{

using namespace carina::test;

constexpr double kRounding = 1e-9;

/// Falls by 1 % a second from 100 % at 0 s to 80 % at 20 s, and rises as fast.
double saturationAt(double t) { return 0.80 + 0.01 * std::abs(t - 20.0); }

OxygenFigures figuresOfAFall(double step_s)
{
    OxygenMeter meter;
    for (double t = 0.0; t < 40.0 + kRounding; t += step_s)
        meter.add(courseTime(t), saturatedBy(saturationAt(t)));
    return meter.figures().value();
}

} // namespace

class TestPatientMeters : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void findTheLowestSaturation();
    void countTheTimeBelowNinety();
    void sayNothingBeforeTheFirstValue();
    void measureAForceThatRisesAndFalls();
    void holdNoForceAcrossAGap();
    void ignoreWhatIsNotLater();
    void keepTheFirstOfEqualValues();
    void countNinetyItselfAsEnough();
};

void TestPatientMeters::findTheLowestSaturation()
{
    const OxygenFigures figures = figuresOfAFall(0.25);
    QVERIFY(std::abs(figures.first - 1.0) < kRounding);
    QVERIFY(std::abs(figures.lowest - 0.80) < kRounding);
    QCOMPARE(figures.lowestAt, courseTime(20.0));
}

/// From 10 to 30 s, to a step of the samples.
void TestPatientMeters::countTheTimeBelowNinety()
{
    constexpr double kStep_s = 0.25;
    const OxygenFigures figures = figuresOfAFall(kStep_s);
    QVERIFY(std::abs(toSeconds(figures.below) - 20.0) <= kStep_s + kRounding);
    QVERIFY(std::abs(toSeconds(figures.fellBelow.value() - courseTime(10.0)))
            <= kStep_s + kRounding);
}

void TestPatientMeters::sayNothingBeforeTheFirstValue()
{
    QVERIFY(!OxygenMeter{}.figures());
    QVERIFY(!ForceMeter{kIncisorLimits}.figures());
}

/// A triangle to 50 N in 10 s and back: mean 25 N, 500 Ns, above 20 N for 12 s and above 40 N for
/// 4 s.
void TestPatientMeters::measureAForceThatRisesAndFalls()
{
    constexpr double kStep_s = 0.01;
    ForceMeter meter{kIncisorLimits};
    for (int i = 0; i <= 2000; ++i) {
        const double t = i * kStep_s;
        meter.add(courseTime(t), newtons(50.0 - 5.0 * std::abs(t - 10.0)));
    }
    const ForceFigures figures = meter.figures().value();
    QVERIFY(std::abs(inNewtons(figures.peak) - 50.0) < 0.1);
    QVERIFY(std::abs(toSeconds(figures.peakAt - courseTime(10.0))) <= kStep_s);
    QVERIFY(std::abs(inNewtons(figures.mean) - 25.0) < 0.1);
    QVERIFY(std::abs(figures.impulse - 500.0) < 1.0);
    QVERIFY(std::abs(toSeconds(figures.touched) - 20.0) < 2.0 * kStep_s + kRounding);
    QVERIFY(std::abs(toSeconds(figures.aboveWarning) - 12.0) < 2.0 * kStep_s + kRounding);
    QVERIFY(std::abs(toSeconds(figures.aboveFault) - 4.0) < 2.0 * kStep_s + kRounding);
}

void TestPatientMeters::holdNoForceAcrossAGap()
{
    ForceMeter meter{kTongueLimits};
    meter.add(courseTime(0.0), newtons(50.0));
    meter.add(courseTime(30.0), newtons(0.0));
    QCOMPARE(meter.figures()->touched, ForceMeter::kLongestGap);
    QCOMPARE(meter.figures()->aboveWarning, ForceMeter::kLongestGap);
    QCOMPARE(meter.figures()->aboveFault, Duration{});
}

void TestPatientMeters::ignoreWhatIsNotLater()
{
    ForceMeter force{kIncisorLimits};
    OxygenMeter oxygen;
    for (const double t : {1.0, 1.0, 0.5}) {
        force.add(courseTime(t), newtons(t < 1.0 || force.figures() ? 50.0 : 10.0));
        oxygen.add(courseTime(t), saturatedBy(t < 1.0 || oxygen.figures() ? 0.5 : 0.95));
    }
    QCOMPARE(inNewtons(force.figures()->peak), 10.0);
    QCOMPARE(oxygen.figures()->lowest, 0.95);
}

void TestPatientMeters::keepTheFirstOfEqualValues()
{
    ForceMeter force{kIncisorLimits};
    OxygenMeter oxygen;
    for (const double t : {1.0, 2.0, 3.0}) {
        force.add(courseTime(t), newtons(t > 1.5 ? 10.0 : 0.0));
        oxygen.add(courseTime(t), saturatedBy(t > 1.5 ? 0.85 : 0.95));
    }
    QCOMPARE(force.figures()->peakAt, courseTime(2.0));
    QCOMPARE(oxygen.figures()->lowestAt, courseTime(2.0));
    QCOMPARE(oxygen.figures()->fellBelow.value(), courseTime(2.0));
}

void TestPatientMeters::countNinetyItselfAsEnough()
{
    OxygenMeter oxygen;
    for (const double t : {1.0, 2.0, 3.0})
        oxygen.add(courseTime(t), saturatedBy(kLowSaturation));
    QCOMPARE(oxygen.figures()->below, Duration{});
    QVERIFY(!oxygen.figures()->fellBelow);
}

CARINA_TEST(TestPatientMeters)

} // namespace carina::patient_meters_test

#include "tst_patient_meters.moc"
