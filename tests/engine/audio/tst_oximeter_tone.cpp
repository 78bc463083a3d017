#include "engine/audio/oximeter_tone.h"
#include "tests/engine/audio/measured_sound.h"
#include "tests/support/test_class.h"

namespace carina::oximeter_tone_test
{

using namespace carina::test;

constexpr double kPitchStep_hz = 1.0; ///< to which a tone of a tenth of a second is measured
constexpr double kPitch_hz = 4.0;     ///< tolerance

class TestOximeterTone : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void fallsByAnOctaveForEachFifthOfSaturation()
    {
        QCOMPARE(oximeterPitch(1.0).si, 880.0);
        QVERIFY(std::abs(oximeterPitch(0.8).si - 440.0) < 1e-9);
        QVERIFY(std::abs(oximeterPitch(0.6).si - 220.0) < 1e-9);
        QCOMPARE(oximeterPitch(0.3).si, oximeterPitch(0.5).si);
        QCOMPARE(oximeterPitch(1.2).si, oximeterPitch(1.0).si);
    }

    // A semitone is 6 %; a step of one per cent of saturation is more than half of one everywhere.
    void changesByTheSameRatioAtEachPerCent()
    {
        for (double saturation = 0.60; saturation < 0.995; saturation += 0.01) {
            const double ratio = oximeterPitch(saturation + 0.01) / oximeterPitch(saturation);
            QVERIFY(std::abs(ratio - std::exp2(1.0 / 20.0)) < 1e-9);
        }
    }

    void soundsAtItsPitch_data()
    {
        QTest::addColumn<double>("saturation");
        QTest::newRow("full") << 1.0;
        QTest::newRow("usual") << 0.97;
        QTest::newRow("alarming") << 0.85;
        QTest::newRow("very low") << 0.6;
    }

    void soundsAtItsPitch()
    {
        QFETCH(double, saturation);
        OximeterTone tone;
        tone.pulse(saturation);
        const auto samples = heard(tone, 0.12);
        const double pitch = oximeterPitch(saturation).si;
        const double found = loudest(samples, 100.0, 1000.0, kPitchStep_hz);
        QVERIFY2(std::abs(found - pitch) < kPitch_hz, qPrintable(QString::number(found)));
    }

    void soundsOncePerPulse()
    {
        OximeterTone tone;
        QCOMPARE(effective(heard(tone, 0.1)), 0.0);
        tone.pulse(0.97);
        tone.pulse(0.97); // while it sounds
        const auto samples = heard(tone, 1.0);
        const double lasts_s =
            OximeterTone::kRise_s + OximeterTone::kPlateau_s + OximeterTone::kFall_s;
        QVERIFY(effective(between(samples, 0.0, lasts_s)) > 0.2);
        QCOMPARE(effective(between(samples, lasts_s + 0.001, 1.0)), 0.0);
    }

    void doesNotClick()
    {
        OximeterTone tone;
        tone.pulse(1.0);
        const auto samples = heard(tone, 0.2);
        // A sine of the third harmonic changes by at most 2 pi f / rate in a sample.
        QVERIFY(largestStep(samples) < 2.0 * std::numbers::pi * 3.0 * 880.0 / kSoundRate);
        QVERIFY(std::abs(samples.front()) < 1e-9);
    }
};

CARINA_TEST(TestOximeterTone)

} // namespace carina::oximeter_tone_test

#include "tst_oximeter_tone.moc"
