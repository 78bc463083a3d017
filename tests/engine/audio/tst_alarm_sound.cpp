#include "engine/audio/alarm_sound.h"
#include "tests/engine/audio/measured_sound.h"
#include "tests/support/test_class.h"

namespace carina::alarm_sound_test
{

using namespace carina::test;

namespace
{

/// When the envelope of a pulse is above a share of its greatest value.
struct Mark {
    double begin_s;
    double end_s;

    [[nodiscard]] double lasts_s() const { return end_s - begin_s; }
};

/// What tables 3 and 4 of IEC 60601-1-8:2006 ask of a priority.
struct Asked {
    std::size_t pulses;
    double shortest_s, longest_s; ///< effective duration of a pulse
    double leastSpacing_s, mostSpacing_s;
    double leastPause_s; ///< between bursts
    double mostPause_s;
};

Asked askedOf(AlarmPriority priority)
{
    switch (priority) {
    case AlarmPriority::High:
        return {10, 0.075, 0.2, 0.05, 0.125, 2.5, 15.0};
    case AlarmPriority::Medium:
        return {3, 0.125, 0.25, 0.125, 0.25, 2.5, 30.0};
    case AlarmPriority::Low:
        break;
    }
    return {2, 0.125, 0.25, 0.125, 0.25, 15.0, 1e9};
}

/// The envelope of what sounds: the greatest amplitude within four thousandths of a second around,
/// more than a period of the lowest pitch. @returns where it is above a threshold
std::vector<Mark> pulsesIn(std::span<const double> samples, double threshold)
{
    const auto half = static_cast<std::size_t>(0.002 * kSoundRate);
    std::vector<Mark> marks;
    bool isAbove = false;
    std::size_t lastLoud = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const double time_s = static_cast<double>(i) / kSoundRate;
        if (std::abs(samples[i]) > threshold) {
            if (!isAbove)
                marks.push_back({time_s, time_s});
            isAbove = true;
            lastLoud = i;
            marks.back().end_s = time_s;
        } else if (isAbove && i > lastLoud + 2 * half) {
            isAbove = false;
        }
    }
    return marks;
}

std::vector<double> burstOf(AlarmPriority priority, double seconds)
{
    AlarmSound sound;
    sound.set(priority);
    return heard(sound, seconds);
}

double greatest(std::span<const double> samples)
{
    double most = 0.0;
    for (const double sample : samples)
        most = std::max(most, std::abs(sample));
    return most;
}

} // namespace

class TestAlarmSound : public QObject
{
    Q_OBJECT

private:
    static void namePriorities()
    {
        QTest::addColumn<int>("priority");
        QTest::newRow("low") << 0;
        QTest::newRow("medium") << 1;
        QTest::newRow("high") << 2;
    }

private Q_SLOTS:
    void hasPulsesAndSpacingsOfTheStandard_data() { namePriorities(); }
    void hasPulsesAndSpacingsOfTheStandard()
    {
        QFETCH(int, priority);
        const auto of = static_cast<AlarmPriority>(priority);
        const Asked asked = askedOf(of);
        const AlarmBurst& burst = alarmBurst(of);
        QCOMPARE(burst.pulses.size(), asked.pulses);
        // From the envelope that is computed: whichever threshold a meter uses, it fits.
        for (const double threshold : {0.1, 0.5, 0.9}) {
            std::vector<Mark> marks;
            for (const auto& pulse : burst.pulses) {
                Mark mark{1e9, 0.0};
                for (double t = 0.0; t < pulse.tone.lasts_s(); t += 1e-4)
                    if (envelopeOf(pulse.tone, t) > threshold)
                        mark = {std::min(mark.begin_s, t), t};
                marks.push_back({pulse.begin_s + mark.begin_s, pulse.begin_s + mark.end_s});
                QVERIFY(mark.lasts_s() >= asked.shortest_s && mark.lasts_s() <= asked.longest_s);
            }
            for (std::size_t i = 1; i < marks.size(); ++i) {
                const double spacing_s = marks[i].begin_s - marks[i - 1].end_s;
                if (of == AlarmPriority::High && i == 5) // between the two groups of five
                    QVERIFY(spacing_s >= 0.35 && spacing_s <= 1.3);
                else if (of == AlarmPriority::High && (i == 3 || i == 8))
                    QVERIFY(
                        std::abs(spacing_s
                                 - (2.0 * (marks[1].begin_s - marks[0].end_s) + marks[0].lasts_s()))
                        < 1e-3);
                else
                    QVERIFY2(spacing_s >= asked.leastSpacing_s && spacing_s <= asked.mostSpacing_s,
                             qPrintable(QString::number(spacing_s)));
            }
            const double pause_s = burst.period_s - marks.back().end_s + marks.front().begin_s;
            QVERIFY(pause_s >= asked.leastPause_s && pause_s <= asked.mostPause_s);
        }
    }

    // From 10 to 90 % within 10 to 40 % of the pulse's effective duration.
    void risesAsTheStandardAsks_data() { namePriorities(); }
    void risesAsTheStandardAsks()
    {
        QFETCH(int, priority);
        for (const auto& pulse : alarmBurst(static_cast<AlarmPriority>(priority)).pulses) {
            const auto firstAbove = [&](double level) {
                double t = 0.0;
                while (envelopeOf(pulse.tone, t) <= level)
                    t += 1e-4;
                return t;
            };
            const double rise_s = firstAbove(0.9) - firstAbove(0.1);
            const double effective_s = pulse.tone.lasts_s() - 2.0 * firstAbove(0.9);
            QVERIFY(rise_s >= 0.1 * effective_s && rise_s <= 0.4 * effective_s);
        }
    }

    void soundsWithFourHarmonicsAtLeast_data() { namePriorities(); }
    void soundsWithFourHarmonicsAtLeast()
    {
        QFETCH(int, priority);
        const auto of = static_cast<AlarmPriority>(priority);
        const TonePulse& tone = alarmBurst(of).pulses.back().tone;
        const double begin_s = alarmBurst(of).pulses.back().begin_s;
        const auto samples = burstOf(of, begin_s + tone.lasts_s());
        const auto pulse = between(samples, begin_s, begin_s + tone.lasts_s());
        const double pitch = loudest(pulse, 150.0, 1000.0, 1.0);
        QVERIFY2(std::abs(pitch - tone.pitch.si) < 4.0, qPrintable(QString::number(pitch)));
        const double fundamental = amplitudeAt(pulse, tone.pitch.si);
        int harmonics = 0;
        for (int n = 1; n * tone.pitch.si <= 4000.0; ++n) {
            const double decibels =
                20.0 * std::log10(amplitudeAt(pulse, n * tone.pitch.si) / fundamental);
            const bool isWithin = n * tone.pitch.si >= 300.0 && std::abs(decibels) <= 15.0;
            harmonics += isWithin ? 1 : 0;
        }
        QVERIFY2(harmonics >= 4, qPrintable(QString::number(harmonics)));
    }

    // The samples themselves, not what they are computed from.
    void playsWhatItsBurstSays_data() { namePriorities(); }
    void playsWhatItsBurstSays()
    {
        QFETCH(int, priority);
        const auto of = static_cast<AlarmPriority>(priority);
        const AlarmBurst& burst = alarmBurst(of);
        const auto samples = burstOf(of, burst.period_s + burst.pulses[1].begin_s);
        const auto marks = pulsesIn(samples, 0.1 * greatest(samples));
        QCOMPARE(marks.size(), burst.pulses.size() + 1); // the next burst has begun
        for (std::size_t i = 0; i < marks.size(); ++i) {
            const double begin_s =
                i < burst.pulses.size() ? burst.pulses[i].begin_s : burst.period_s;
            QVERIFY(marks[i].begin_s >= begin_s && marks[i].begin_s < begin_s + 0.03);
        }
    }

    void changesAndEndsWithoutAClick()
    {
        AlarmSound sound;
        sound.set(AlarmPriority::Medium);
        auto samples = heard(sound, 0.11); // in the middle of a pulse
        sound.set(AlarmPriority::High);
        for (const double sample : heard(sound, 0.15))
            samples.push_back(sample);
        sound.set(std::nullopt);
        const auto end = heard(sound, 1.0);
        samples.insert(samples.end(), end.begin(), end.end());
        QVERIFY(largestStep(samples) < 0.2);
        QCOMPARE(effective(between(end, 0.05, 1.0)), 0.0);
    }

    void beginsTheMoreUrgentBurstAtOnce()
    {
        AlarmSound sound;
        sound.set(AlarmPriority::Low);
        (void)heard(sound, 5.0); // in its pause
        sound.set(AlarmPriority::High);
        QVERIFY(effective(heard(sound, 0.25)) > 0.1);
    }
};

CARINA_TEST(TestAlarmSound)

} // namespace carina::alarm_sound_test

#include "tst_alarm_sound.moc"
