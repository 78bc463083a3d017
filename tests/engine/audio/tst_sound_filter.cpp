#include "engine/audio/gain_ramp.h"
#include "engine/audio/noise.h"
#include "engine/audio/sound_filter.h"
#include "tests/engine/audio/measured_sound.h"
#include "tests/support/test_class.h"

namespace carina::sound_filter_test
{

using namespace carina::test;

namespace
{

/// By how much a filter makes a sine louder, once it has settled.
double gainAt(SoundFilter filter, double frequency_hz)
{
    std::vector<double> out;
    for (int i = 0; i < 24000; ++i) {
        const double in = std::sin(2.0 * std::numbers::pi * frequency_hz * i / kSoundRate);
        const double filtered = filter.next(in);
        if (i >= 12000)
            out.push_back(filtered);
    }
    return amplitudeAt(out, frequency_hz);
}

constexpr double kHalfPower = 0.70710678;
constexpr double kGain = 0.005; ///< tolerance

} // namespace

class TestSoundFilter : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    // Butterworth of second order: 1 / sqrt(1 + (f / corner)^4), far below half the rate.
    void passesWhatIsBelowItsCorner()
    {
        QVERIFY(std::abs(gainAt(SoundFilter::lowPass(1000.0), 100.0) - 1.0) < kGain);
        QVERIFY(std::abs(gainAt(SoundFilter::lowPass(1000.0), 1000.0) - kHalfPower) < kGain);
        QVERIFY(std::abs(gainAt(SoundFilter::lowPass(1000.0), 4000.0) - 1.0 / 16.0) < kGain);
    }

    void passesWhatIsAboveItsCorner()
    {
        QVERIFY(std::abs(gainAt(SoundFilter::highPass(1000.0), 8000.0) - 1.0) < kGain);
        QVERIFY(std::abs(gainAt(SoundFilter::highPass(1000.0), 1000.0) - kHalfPower) < kGain);
        QVERIFY(std::abs(gainAt(SoundFilter::highPass(1000.0), 250.0) - 1.0 / 16.0) < kGain);
    }

    // xorshift64* is uniform: mean 0, power 1/3; from one sample to the next nothing follows.
    void drawsWhiteNoise()
    {
        Noise noise{5};
        const auto drawn = heard(noise, 2.0);
        double mean = 0.0;
        double next = 0.0;
        for (std::size_t i = 1; i < drawn.size(); ++i) {
            QVERIFY(drawn[i] >= -1.0 && drawn[i] < 1.0);
            mean += drawn[i];
            next += drawn[i] * drawn[i - 1];
        }
        const double count = static_cast<double>(drawn.size());
        QVERIFY(std::abs(mean / count) < 0.01);
        QVERIFY(std::abs(next / count) < 0.01);
        QVERIFY(std::abs(effective(drawn) - std::sqrt(1.0 / 3.0)) < 0.01);
    }

    void rampsInAStraightLine()
    {
        GainRamp ramp{0.0, 0.01}; // 480 samples
        ramp.aim(1.0);
        for (int i = 1; i <= 480; ++i)
            QVERIFY(std::abs(ramp.next() - i / 480.0) < 1e-9);
        QCOMPARE(ramp.next(), 1.0);
        ramp.aim(0.0);
        (void)ramp.next();
        ramp.aim(0.0); // asked for again: it goes on
        for (int i = 2; i < 480; ++i)
            (void)ramp.next();
        QVERIFY(ramp.now() > 0.0);
        QCOMPARE(ramp.next(), 0.0);
    }
};

CARINA_TEST(TestSoundFilter)

} // namespace carina::sound_filter_test

#include "tst_sound_filter.moc"
