#include "engine/physiology/heart_curves.h"
#include "tests/engine/physiology/bed.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace carina::heart_curves_test
{

namespace
{

constexpr int kSamples = 2000; // of a beat

template <class Curve> double phaseOfHighest(Curve curve, double rate_perS)
{
    int highest = 0;
    for (int i = 0; i < kSamples; ++i)
        if (curve(double(i) / kSamples, rate_perS) > curve(double(highest) / kSamples, rate_perS))
            highest = i;
    return double(highest) / kSamples;
}

void expectAlike(const std::vector<double>& peaks)
{
    constexpr double kAlike = 0.98;
    const auto [lowest, highest] = std::ranges::minmax(peaks);
    QVERIFY2(lowest > kAlike * highest,
             qPrintable(QStringLiteral("%1 to %2 mV").arg(lowest).arg(highest)));
}

} // namespace

class TestHeartCurves : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isContinuousFromBeatToBeat_data();
    void isContinuousFromBeatToBeat();
    void hasAnRWaveAndASmallerTWave();
    void beatsAtTheFingerAfterTheHeart();
    void drawsEvenBeatsEquallyHigh_data();
    void drawsEvenBeatsEquallyHigh();
    void drawsThoseOfAPatientEquallyHigh();
};

void TestHeartCurves::isContinuousFromBeatToBeat_data()
{
    QTest::addColumn<double>("perMin");
    QTest::newRow("slow") << 20.0;
    QTest::newRow("adult") << 72.0;
    QTest::newRow("newborn") << 150.0;
}

void TestHeartCurves::isContinuousFromBeatToBeat()
{
    constexpr double kStep_mV = 0.03;
    constexpr double kStep = 0.06;
    QFETCH(const double, perMin);
    const double rate = perMin / 60.0;
    const double last = std::nextafter(1.0, 0.0);
    QVERIFY(std::abs(electrocardiogram_mV(last, rate) - electrocardiogram_mV(0.0, rate))
            < kStep_mV);
    QVERIFY(std::abs(pulseWave(last, rate) - pulseWave(0.0, rate)) < kStep);
    for (int i = 1; i < kSamples; ++i) {
        const double before = pulseWave(double(i - 1) / kSamples, rate);
        const double now = pulseWave(double(i) / kSamples, rate);
        QVERIFY(now >= 0.0 && now <= 1.0);
        QVERIFY2(std::abs(now - before) < kStep, qPrintable(QString::number(i)));
    }
}

void TestHeartCurves::hasAnRWaveAndASmallerTWave()
{
    const double rate = 1.2;
    const double r = phaseOfHighest(electrocardiogram_mV, rate);
    QVERIFY(electrocardiogram_mV(r, rate) > 0.8 && electrocardiogram_mV(r, rate) < 1.5);
    const double t = r + 0.26 * std::sqrt(rate); // the interval goes with the root of the beat's
    QVERIFY(electrocardiogram_mV(t, rate) > 0.2);
    QVERIFY(electrocardiogram_mV(t, rate) < 0.5 * electrocardiogram_mV(r, rate));
    QVERIFY(electrocardiogram_mV(std::nextafter(1.0, 0.0), rate) < 0.1);
}

void TestHeartCurves::beatsAtTheFingerAfterTheHeart()
{
    for (const double rate : {0.5, 1.2, 2.0}) {
        const double r = phaseOfHighest(electrocardiogram_mV, rate);
        const double pulse = phaseOfHighest(pulseWave, rate);
        const double late_s = (pulse - r - std::floor(pulse - r)) / rate;
        QVERIFY2(late_s > 0.2 && late_s < 0.5, qPrintable(QString::number(late_s)));
    }
}

void TestHeartCurves::drawsEvenBeatsEquallyHigh_data()
{
    QTest::addColumn<double>("perMin");
    QTest::newRow("72") << 72.0;
    QTest::newRow("80") << 80.0;
    QTest::newRow("90") << 90.0;
    QTest::newRow("151") << 151.0;
}

// Beats whose R waves go up and down in turn are a sign of a tamponade.
void TestHeartCurves::drawsEvenBeatsEquallyHigh()
{
    constexpr double kStep_s = 0.02;
    QFETCH(const double, perMin);
    const double rate = perMin / 60.0;
    std::vector<double> peaks(12, 0.0);
    for (int i = 0;; ++i) {
        const double beats = i * kStep_s * rate;
        if (beats >= double(peaks.size()))
            break;
        double& peak = peaks[std::size_t(beats)];
        peak = std::max(peak, electrocardiogramPeak_mV(beats - std::floor(beats), rate, kStep_s));
    }
    expectAlike(peaks);
    QVERIFY(std::ranges::max(peaks) < 1.2);
}

// Who breathes quietly, and whose rate hardly changes from beat to beat.
void TestHeartCurves::drawsThoseOfAPatientEquallyHigh()
{
    constexpr double kOfR_mV = 0.6;
    test::Bed bed{test::kTwelve};
    bed.run(60.0);
    std::vector<double> peaks;
    double last = 0.0;
    bed.runWhile(12.0, [&] {
        const double now = bed.body.vitals().electrocardiogram;
        if (now > kOfR_mV) {
            if (last > kOfR_mV)
                peaks.back() = std::max(peaks.back(), now);
            else
                peaks.push_back(now);
        }
        last = now;
        return true;
    });
    QVERIFY(peaks.size() > 10);
    expectAlike(peaks);
}

CARINA_TEST(TestHeartCurves)

} // namespace carina::heart_curves_test

#include "tst_heart_curves.moc"
