#pragma once

#include "engine/audio/alarm_sound.h"
#include "engine/audio/auscultation.h"
#include "engine/audio/breath_sound.h"
#include "engine/audio/heart_tones.h"
#include "engine/audio/oximeter_tone.h"
#include "engine/audio/sound_mixer.h"

#include <span>

namespace carina
{

/// What moves in the patient, and sounds.
struct BreathFlows {
    VolumeFlow right{}; ///< into the lung
    VolumeFlow left{};
    VolumeFlow stomach{};
    double rightObstruction = 0.0; ///< 0 to 1: how much it wheezes
    double leftObstruction = 0.0;

    friend bool operator==(const BreathFlows&, const BreathFlows&) = default;
};

/// All that is heard beside the patient: the monitor's tones and alarms, and what a stethoscope
/// hears. The same calls give the same samples where the mathematical library is the same.
class BedsideSounds
{
public:
    [[nodiscard]] SoundMixer& mixer() { return m_mixer; }

    /// The oximeter found a pulse.
    void pulse(double saturation) { m_oximeter.pulse(saturation); }
    /// The heart beat. @pre heartRate is above 0
    void beat(Frequency heartRate) { m_heart.beat(heartRate); }
    void setAlarm(std::optional<AlarmPriority> priority) { m_alarm.set(priority); }
    void setBreath(const BreathFlows& flows);
    /// Where the stethoscope is; nowhere at first.
    void setAuscultation(const AuscultationGains& gains);

    /// The next samples, of one channel at kSoundRate.
    void render(std::span<float> samples);

private:
    [[nodiscard]] double nextBreath();

    OximeterTone m_oximeter;
    AlarmSound m_alarm;
    BreathSound m_right{BreathPlace::Lung, 11};
    BreathSound m_left{BreathPlace::Lung, 23};
    BreathSound m_trachea{BreathPlace::Trachea, 29};
    StomachSound m_stomach{37};
    HeartTones m_heart;
    GainRamp m_rightGain{0.0};
    GainRamp m_leftGain{0.0};
    GainRamp m_tracheaGain{0.0};
    GainRamp m_stomachGain{0.0};
    GainRamp m_heartGain{0.0};
    SoundMixer m_mixer;
};

} // namespace carina
