#include "engine/audio/sound_mixer.h"
#include "tests/engine/audio/measured_sound.h"
#include "tests/support/test_class.h"

namespace carina::sound_mixer_test
{

using namespace carina::test;

namespace
{

/// A sine of 500 Hz of one kind through a mixer.
class Sine
{
public:
    Sine(SoundMixer& mixer, SoundKind kind, double amplitude)
        : m_mixer{mixer}, m_kind{kind}, m_amplitude{amplitude}
    {
    }

    double next()
    {
        SoundSamples samples{};
        samples[static_cast<std::size_t>(m_kind)] =
            m_amplitude * std::sin(2.0 * std::numbers::pi * 500.0 * m_sample++ / kSoundRate);
        return m_mixer.mix(samples);
    }

private:
    SoundMixer& m_mixer;
    SoundKind m_kind;
    double m_amplitude;
    double m_sample = 0.0;
};

} // namespace

class TestSoundMixer : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void addsTheKinds()
    {
        SoundMixer mixer;
        QVERIFY(std::abs(mixer.mix({0.1, 0.2, 0.3, 0.05}) - 0.65) < 1e-12);
        mixer.setMuted(SoundKind::Breath, true);
        for (int i = 0; i < 2000; ++i)
            (void)mixer.mix({});
        QVERIFY(std::abs(mixer.mix({0.1, 0.2, 0.3, 0.05}) - 0.35) < 1e-12);
    }

    void isAsLoudAsItsVolume()
    {
        SoundMixer mixer;
        mixer.setVolume(SoundKind::Alarm, 0.25);
        Sine sine{mixer, SoundKind::Alarm, 0.8};
        (void)heard(sine, 0.1);
        QVERIFY(std::abs(amplitudeAt(heard(sine, 0.2), 500.0) - 0.2) < 1e-3);
    }

    void mutesOneKindAlone()
    {
        SoundMixer mixer;
        mixer.setMuted(SoundKind::Oximeter, true);
        Sine mute{mixer, SoundKind::Oximeter, 0.8};
        Sine loud{mixer, SoundKind::Alarm, 0.8};
        (void)heard(mute, 0.1);
        QCOMPARE(effective(heard(mute, 0.1)), 0.0);
        QVERIFY(effective(heard(loud, 0.1)) > 0.5);
        mixer.setMuted(SoundKind::Oximeter, false);
        (void)heard(mute, 0.1);
        QVERIFY(effective(heard(mute, 0.1)) > 0.5); // as loud as before
    }

    void changesItsVolumeWithoutAClick()
    {
        SoundMixer mixer;
        Sine sine{mixer, SoundKind::Alarm, 0.8};
        auto samples = heard(sine, 0.1005); // ends where the sine is at its greatest
        mixer.setMuted(SoundKind::Alarm, true);
        const auto end = heard(sine, 0.1);
        samples.insert(samples.end(), end.begin(), end.end());
        QVERIFY(largestStep(samples) < 1.1 * 0.8 * 2.0 * std::numbers::pi * 500.0 / kSoundRate);
    }

    void staysBelowItsCeiling()
    {
        SoundMixer mixer;
        Sine sine{mixer, SoundKind::Breath, 5.0};
        for (const double sample : heard(sine, 0.5))
            QVERIFY(std::abs(sample) <= SoundMixer::kCeiling + 1e-12);
        Sine quiet{mixer, SoundKind::Breath, 0.1};
        (void)heard(quiet, 2.0); // ten time constants after the loud one
        QVERIFY(std::abs(amplitudeAt(heard(quiet, 0.2), 500.0) - 0.1) < 1e-3);
    }
};

CARINA_TEST(TestSoundMixer)

} // namespace carina::sound_mixer_test

#include "tst_sound_mixer.moc"
