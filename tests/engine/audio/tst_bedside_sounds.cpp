#include "engine/audio/bedside_sounds.h"
#include "tests/engine/audio/measured_sound.h"
#include "tests/support/test_class.h"

namespace carina::bedside_sounds_test
{

using namespace carina::test;

namespace
{

std::vector<double> rendered(BedsideSounds& sounds, double seconds)
{
    std::vector<float> samples(static_cast<std::size_t>(seconds * kSoundRate));
    sounds.render(samples);
    return {samples.begin(), samples.end()};
}

} // namespace

class TestBedsideSounds : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isSilentUntilSomethingSounds()
    {
        BedsideSounds sounds;
        QCOMPARE(effective(rendered(sounds, 0.5)), 0.0);
    }

    // A tube in the right main bronchus: the left side is silent but for what comes through.
    void hearsTheSideThatIsVentilated()
    {
        const auto at = [](const AuscultationGains& gains) {
            BedsideSounds sounds;
            sounds.setBreath({litresPerSecond(0.4), {}, {}});
            sounds.setAuscultation(gains);
            (void)rendered(sounds, 0.1);
            return effective(rendered(sounds, 2.0));
        };
        const double right = at({1.0, kThroughChest, 0.0, 0.0, 0.0});
        const double left = at({kThroughChest, 1.0, 0.0, 0.0, 0.0});
        QVERIFY(right > 0.02);
        QVERIFY(std::abs(left / right - kThroughChest) < 0.01);
        QVERIFY(at({0.0, 0.0, 0.0, 0.0, 1.0}) > 0.02); // at the trachea
        QCOMPARE(at({}), 0.0);
    }

    // In the oesophagus.
    void gurglesOverTheStomach()
    {
        BedsideSounds sounds;
        sounds.setBreath({{}, {}, litresPerSecond(0.4)});
        sounds.setAuscultation({0.0, 0.0, 1.0, 0.0, 0.0});
        QVERIFY(effective(rendered(sounds, 2.0)) > 0.02);
    }

    void hearsTheHeartOnlyThroughTheStethoscope()
    {
        BedsideSounds sounds;
        sounds.beat(perMinute(70.0));
        QCOMPARE(effective(rendered(sounds, 1.0)), 0.0);
        sounds.setAuscultation({0.0, 0.0, 0.0, 1.0, 0.0});
        (void)rendered(sounds, 0.1);
        sounds.beat(perMinute(70.0));
        QVERIFY(effective(rendered(sounds, 0.5)) > 0.1);
    }

    void mutesByKind()
    {
        BedsideSounds sounds;
        sounds.mixer().setMuted(SoundKind::Alarm, true);
        (void)rendered(sounds, 0.1);
        sounds.setAlarm(AlarmPriority::High);
        QCOMPARE(effective(rendered(sounds, 1.0)), 0.0);
        sounds.pulse(0.97);
        QVERIFY(effective(rendered(sounds, 0.1)) > 0.1);
    }

    void rendersTheSameInOtherBlocks()
    {
        const auto scene = [](std::size_t block) {
            BedsideSounds sounds;
            sounds.setAlarm(AlarmPriority::Medium);
            sounds.pulse(0.93);
            sounds.setBreath({litresPerSecond(0.3), litresPerSecond(0.2), litresPerSecond(0.1)});
            sounds.setAuscultation({0.5, 0.4, 0.3, 0.0, 0.1});
            std::vector<float> samples(9600);
            for (std::size_t at = 0; at < samples.size(); at += block)
                sounds.render(std::span{samples}.subspan(at, block));
            return samples;
        };
        QCOMPARE(scene(480), scene(9600));
        QCOMPARE(scene(1), scene(9600));
    }
};

CARINA_TEST(TestBedsideSounds)

} // namespace carina::bedside_sounds_test

#include "tst_bedside_sounds.moc"
