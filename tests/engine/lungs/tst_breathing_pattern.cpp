#include "engine/lungs/breathing_pattern.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace carina;

namespace
{

constexpr double kTolerance_ml = 1e-9;

BreathingPattern child(double inspiratoryFraction)
{
    return {perMinute(19.0), millilitres(280.0), inspiratoryFraction};
}

double volumeAt_ml(const BreathingPattern& pattern, double phase)
{
    return inMillilitres(inspiredVolume(pattern, phase));
}

} // namespace

class TestBreathingPattern : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void startsAndEndsAtExactlyNothing_data() { fractions(); }
    void startsAndEndsAtExactlyNothing();
    void holdsExactlyTheTidalVolumeAtTheEndOfInspiration_data() { fractions(); }
    void holdsExactlyTheTidalVolumeAtTheEndOfInspiration();
    void fillsByAHalfSineOfFlow_data() { fractions(); }
    void fillsByAHalfSineOfFlow();
    void emptiesByEqualRatiosInEqualTimes_data() { fractions(); }
    void emptiesByEqualRatiosInEqualTimes();
    void neverJumps_data() { fractions(); }
    void neverJumps();
    void doesNotDependOnTheRate();

private:
    static void fractions();
};

void TestBreathingPattern::fractions()
{
    QTest::addColumn<double>("inspiratoryFraction");
    QTest::newRow("quick inspiration") << 0.1;
    QTest::newRow("child of 12 years") << 0.41;
    QTest::newRow("even") << 0.5;
    QTest::newRow("quick expiration") << 0.9;
}

void TestBreathingPattern::startsAndEndsAtExactlyNothing()
{
    QFETCH(double, inspiratoryFraction);
    const BreathingPattern pattern = child(inspiratoryFraction);
    QVERIFY(inspiredVolume(pattern, 0.0).si == 0.0);
    QVERIFY(inspiredVolume(pattern, 1.0).si == 0.0);
}

void TestBreathingPattern::holdsExactlyTheTidalVolumeAtTheEndOfInspiration()
{
    QFETCH(double, inspiratoryFraction);
    const BreathingPattern pattern = child(inspiratoryFraction);
    QVERIFY(inspiredVolume(pattern, inspiratoryFraction).si == pattern.tidalVolume.si);
}

// Flow proportional to sin(pi f) integrates to 1/2 (1 - cos(pi f)): at a third of inspiration a
// quarter of the tidal volume is in, at half of it half, at two thirds of it three quarters.
void TestBreathingPattern::fillsByAHalfSineOfFlow()
{
    QFETCH(double, inspiratoryFraction);
    const BreathingPattern pattern = child(inspiratoryFraction);
    const auto at = [&](double f) { return volumeAt_ml(pattern, f * inspiratoryFraction); };
    QVERIFY(std::abs(at(1.0 / 3.0) - 70.0) < kTolerance_ml);
    QVERIFY(std::abs(at(0.5) - 140.0) < kTolerance_ml);
    QVERIFY(std::abs(at(2.0 / 3.0) - 210.0) < kTolerance_ml);
}

// Of an exponential, what leaves in each quarter of expiration is e^(-4/4) of what left before.
void TestBreathingPattern::emptiesByEqualRatiosInEqualTimes()
{
    QFETCH(double, inspiratoryFraction);
    const BreathingPattern pattern = child(inspiratoryFraction);
    const auto at = [&](double quarters) {
        const double phase = inspiratoryFraction + (1.0 - inspiratoryFraction) * quarters / 4.0;
        return volumeAt_ml(pattern, phase);
    };
    const double ratio = 1.0 / std::numbers::e;
    for (int quarter = 0; quarter < 3; ++quarter) {
        const double first = at(quarter) - at(quarter + 1);
        const double second = at(quarter + 1) - at(quarter + 2);
        QVERIFY(first > 0.0);
        QVERIFY(std::abs(second / first - ratio) < 1e-9);
    }
}

void TestBreathingPattern::neverJumps()
{
    QFETCH(double, inspiratoryFraction);
    const BreathingPattern pattern = child(inspiratoryFraction);
    // The steepest slopes there are: pi/2 VT over the share f, and 4 / (1 - e^-4) VT over e.
    const double slope_ml = 280.0
                            * std::max(std::numbers::pi / 2.0 / inspiratoryFraction,
                                       4.0 / (1.0 - std::exp(-4.0)) / (1.0 - inspiratoryFraction));
    constexpr int kSteps = 10000;
    for (int step = 0; step < kSteps; ++step) {
        const double before = volumeAt_ml(pattern, double(step) / kSteps);
        const double after = volumeAt_ml(pattern, double(step + 1) / kSteps);
        QVERIFY(std::abs(after - before) <= slope_ml / kSteps * 1.0001);
        QVERIFY(after >= 0.0 && after <= 280.0);
    }
}

void TestBreathingPattern::doesNotDependOnTheRate()
{
    BreathingPattern slow = child(0.41);
    BreathingPattern fast = slow;
    slow.rate = perMinute(4.0);
    fast.rate = perMinute(60.0);
    for (const double phase : {0.1, 0.41, 0.42, 0.8})
        QCOMPARE(inspiredVolume(slow, phase).si, inspiredVolume(fast, phase).si);
}

QTEST_APPLESS_MAIN(TestBreathingPattern)
#include "tst_breathing_pattern.moc"
