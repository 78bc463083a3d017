#include "engine/audio/breath_sound.h"
#include "tests/engine/audio/measured_sound.h"
#include "tests/support/test_class.h"

namespace carina::breath_sound_test
{

using namespace carina::test;

namespace
{

constexpr double kLong_s = 4.0;

std::vector<double> breath(BreathPlace place, VolumeFlow flow, double obstruction = 0.0)
{
    BreathSound sound{place, 7};
    sound.set(flow, obstruction);
    (void)heard(sound, 0.1); // the ramp
    return heard(sound, kLong_s);
}

} // namespace

class TestBreathSound : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isSilentWithoutFlow()
    {
        QCOMPARE(effective(breath(BreathPlace::Lung, {})), 0.0);
        QCOMPARE(effective(breath(BreathPlace::Lung, {}, 1.0)), 0.0);
        StomachSound stomach{7};
        stomach.set({});
        QCOMPARE(effective(heard(stomach, 1.0)), 0.0);
    }

    // Gavriely and Cugell 1996: the exponent is 1.66.
    void growsWithTheFlowAsMeasured()
    {
        const double quiet = effective(breath(BreathPlace::Trachea, litresPerSecond(0.2)));
        const double loud = effective(breath(BreathPlace::Trachea, litresPerSecond(0.4)));
        const double exponent = std::log2(loud / quiet);
        QVERIFY2(std::abs(exponent - 1.66) < 0.01, qPrintable(QString::number(exponent)));
    }

    void isLouderInInspirationThroughALung()
    {
        const double in = effective(breath(BreathPlace::Lung, litresPerSecond(0.4)));
        const double out = effective(breath(BreathPlace::Lung, litresPerSecond(-0.4)));
        QVERIFY(std::abs(out / in - BreathSound::kExpiration) < 0.01);
    }

    // What has come through a lung lost its high frequencies; in the trachea they end sharply.
    void hasTheSpectrumOfItsPlace()
    {
        const auto lung = breath(BreathPlace::Lung, litresPerSecond(0.5));
        const auto trachea = breath(BreathPlace::Trachea, litresPerSecond(0.5));
        QVERIFY(powerBetween(lung, 400.0, 800.0) < 0.05 * powerBetween(lung, 100.0, 400.0));
        QVERIFY(powerBetween(trachea, 400.0, 800.0) > 0.5 * powerBetween(trachea, 100.0, 400.0));
        QVERIFY(powerBetween(trachea, 1600.0, 2000.0) < 0.1 * powerBetween(trachea, 400.0, 800.0));
        QVERIFY(powerBetween(lung, 0.0, 60.0) < 0.1 * powerBetween(lung, 100.0, 400.0));
    }

    void wheezesWhereItIsNarrow()
    {
        const auto toneOf = [](const std::vector<double>& samples) {
            return powerBetween(samples, 385.0, 415.0, 1.0)
                   / powerBetween(samples, 435.0, 465.0, 1.0);
        };
        const auto free = breath(BreathPlace::Lung, litresPerSecond(-0.4));
        const auto narrow = breath(BreathPlace::Lung, litresPerSecond(-0.4), 0.8);
        const auto narrowIn = breath(BreathPlace::Lung, litresPerSecond(0.4), 0.8);
        QVERIFY(effective(narrow) > 2.0 * effective(free));
        QVERIFY(toneOf(narrow) > 3.0 * toneOf(free));
        const double pitch = loudest(between(narrow, 0.0, 1.0), 200.0, 800.0, 2.0);
        QVERIFY2(std::abs(pitch - BreathSound::kWheeze_hz) < 15.0,
                 qPrintable(QString::number(pitch)));
        QVERIFY(powerBetween(narrow, 385.0, 415.0, 1.0)
                > powerBetween(narrowIn, 385.0, 415.0, 1.0));
    }

    void gurglesInSeparateBubbles()
    {
        StomachSound stomach{7};
        stomach.set(litresPerSecond(0.5));
        const auto samples = heard(stomach, kLong_s);
        QVERIFY(effective(samples) > 0.05);
        int quiet = 0;
        int loud = 0;
        for (double t = 0.0; t < kLong_s - 0.02; t += 0.02) {
            const double part = effective(between(samples, t, t + 0.02));
            quiet += part < 0.01 ? 1 : 0;
            loud += part > 0.1 ? 1 : 0;
        }
        QVERIFY2(quiet > 20 && loud > 20, qPrintable(QStringLiteral("%1 %2").arg(quiet).arg(loud)));
        QVERIFY(powerBetween(samples, 140.0, 420.0) > 5.0 * powerBetween(samples, 500.0, 800.0));
    }

    void followsTheFlowWithoutClicks()
    {
        BreathSound sound{BreathPlace::Lung, 7};
        sound.set(litresPerSecond(0.5), 0.0);
        auto samples = heard(sound, 0.5);
        const double usual = largestStep(samples);
        sound.set({}, 0.0);
        const auto end = heard(sound, 0.5);
        samples.insert(samples.end(), end.begin(), end.end());
        QVERIFY(largestStep(samples) < 1.2 * usual);
        QCOMPARE(effective(between(end, 0.05, 0.5)), 0.0);
    }

    void isTheSameForTheSameSeed()
    {
        QCOMPARE(breath(BreathPlace::Lung, litresPerSecond(0.3)),
                 breath(BreathPlace::Lung, litresPerSecond(0.3)));
    }
};

CARINA_TEST(TestBreathSound)

} // namespace carina::breath_sound_test

#include "tst_breath_sound.moc"
