#include "engine/audio/alarm_sound.h"

#include "engine/audio/sampling.h"

#include <array>
#include <cmath>

namespace carina
{
namespace
{

constexpr Frequency kC4 = hertz(261.63);
constexpr Frequency kE4 = hertz(329.63);
/// Within 15 dB of the fundamental, and at least four of them from 300 to 4000 Hz.
constexpr std::array kAlarmHarmonics{1.0, 0.8, 0.6, 0.5, 0.4, 0.3};

// A half cosine goes from 10 to 90 % in 0.59 of its time and is above 90 % for the last 0.2: with
// these, the pulse lasts 141 ms above 90 % and 180 ms above 10 %, where 75 to 200 ms are asked of
// high priority; and 180 and 240 ms, where 125 to 250 ms are asked of the others.
constexpr double kHighRamp_s = 0.034;
constexpr double kHighPlateau_s = 0.127;
constexpr double kOtherRamp_s = 0.05;
constexpr double kOtherPlateau_s = 0.16;

// From a pulse's begin to the next.
constexpr double kHighStep_s = 0.24;
constexpr double kHighGroupStep_s = 0.48; ///< its pause is two others and a pulse
constexpr double kHighHalf_s = 1.84;      ///< from the first pulse to the sixth
constexpr double kMediumStep_s = 0.4;
constexpr double kLowStep_s = 0.4;
constexpr double kHighPeriod_s = 8.2; ///< 5 s after the last pulse
constexpr double kMediumPeriod_s = 8.5;
constexpr double kLowPeriod_s = 21.0;

TonePulse highPulse() { return {kC4, kAlarmHarmonics, kHighRamp_s, kHighPlateau_s, kHighRamp_s}; }

TonePulse otherPulse(Frequency pitch)
{
    return {pitch, kAlarmHarmonics, kOtherRamp_s, kOtherPlateau_s, kOtherRamp_s};
}

AlarmBurst highBurst()
{
    AlarmBurst burst{{}, kHighPeriod_s};
    for (const double half_s : {0.0, kHighHalf_s}) {
        double begin_s = half_s;
        for (const double step_s : {kHighStep_s, kHighStep_s, kHighGroupStep_s, kHighStep_s, 0.0}) {
            burst.pulses.push_back({begin_s, highPulse()});
            begin_s += step_s;
        }
    }
    return burst;
}

AlarmBurst mediumBurst()
{
    return {{{0.0, otherPulse(kC4)},
             {kMediumStep_s, otherPulse(kC4)},
             {2.0 * kMediumStep_s, otherPulse(kC4)}},
            kMediumPeriod_s};
}

AlarmBurst lowBurst()
{
    return {{{0.0, otherPulse(kE4)}, {kLowStep_s, otherPulse(kC4)}}, kLowPeriod_s};
}

} // namespace

const AlarmBurst& alarmBurst(AlarmPriority priority)
{
    static const std::array kBursts{lowBurst(), mediumBurst(), highBurst()};
    return kBursts[static_cast<std::size_t>(priority)];
}

/// Fades what sounds, and then begins what is wanted.
void AlarmSound::change()
{
    m_gate.aim(0.0);
    if (m_gate.now() > 0.0)
        return;
    m_sounding = m_wanted;
    m_sample = 0;
}

double AlarmSound::next()
{
    if (m_wanted != m_sounding)
        change();
    else if (m_sounding)
        m_gate.aim(1.0);
    const double gate = m_gate.next();
    if (!m_sounding)
        return 0.0;
    const AlarmBurst& burst = alarmBurst(*m_sounding);
    const double time_s = static_cast<double>(m_sample++) / kSoundRate;
    if (time_s >= burst.period_s)
        m_sample = 1;
    const double within_s = time_s >= burst.period_s ? 0.0 : time_s;
    for (const AlarmBurst::Pulse& pulse : burst.pulses)
        if (within_s >= pulse.begin_s && within_s < pulse.begin_s + pulse.tone.lasts_s())
            return gate * sampleOf(pulse.tone, within_s - pulse.begin_s);
    return 0.0;
}

} // namespace carina
