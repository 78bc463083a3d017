#pragma once

#include "engine/audio/bedside_sounds.h"
#include "models/vitals/kept_sounds.h"
#include "models/vitals/pulse_finder.h"
#include "models/vitals/vital_alarms.h"

#include <QObject>

#include <functional>

namespace carina
{

/// Where a bedside monitor has its values from, each at a time of the session. Those of one place
/// are asked for at times that do not decrease, until the model is told to start afresh.
struct VitalsSources {
    /// The present time; nothing while it is not known.
    std::function<std::optional<SessionTime>()> now{};
    /// Nothing where no patient lives at that time, as before a session or in a pause.
    std::function<std::optional<Vitals>(SessionTime)> vitals{};
    /// What moves in the patient and is heard through the chest, as the flows of a grown person of
    /// that loudness; may be empty.
    std::function<std::optional<BreathFlows>(SessionTime)> breath{};
    /// What a stethoscope hears where it is; may be empty, and gives nothing off the chest.
    std::function<std::optional<AuscultationGains>(SessionTime)> stethoscope{};
};

/// A bedside monitor's curves, numbers, alarms and sounds for one patient.
///
/// Curves are sampled at whole multiples of kSampleEvery in session time and numbers change with
/// its whole seconds, so that every program shows the same. Sounds are made here and played by
/// somebody else (SoundOutput); what sounds is also to be seen: pulse(), alarms() and heard(). So
/// they are heard only while these marks are in sight.
class VitalsModel : public QObject
{
    Q_OBJECT

public:
    struct Sample {
        double time_s = 0.0; ///< of the session
        double electrocardiogram_mV = 0.0;
        std::optional<double> pulse{}; ///< 0 to 1; nothing without the oximeter's probe
        std::optional<double> exhaledCO2_mmHg{};
    };
    struct BloodPressure {
        int systolic_mmHg = 0;
        int diastolic_mmHg = 0;
        int mean_mmHg = 0;

        friend bool operator==(const BloodPressure&, const BloodPressure&) = default;
    };
    /// What is not measured is empty.
    struct Numbers {
        std::optional<int> heartRate_perMin{};
        std::optional<int> saturation_percent{};
        std::optional<int> endTidalCO2_mmHg{};
        std::optional<int> respiratoryRate_perMin{};
        std::optional<BloodPressure> pressure{};

        friend bool operator==(const Numbers&, const Numbers&) = default;
    };
    /// What the stethoscope hears: the loudest of about the last second, 0 to 1.
    struct Heard {
        bool isOnChest = false;
        AuscultationGains loudness{};
        bool wheezes = false;

        friend bool operator==(const Heard&, const Heard&) = default;
    };

    static constexpr Duration kSampleEvery = std::chrono::milliseconds{20}; ///< as kBodyStep
    /// After a longer gap the missing samples are skipped.
    static constexpr Duration kLongestGap = std::chrono::seconds{10};
    static constexpr Duration kPulseMark = std::chrono::milliseconds{150};

    /// @param age_years of the patient, for the limits of the alarms
    VitalsModel(VitalsSources sources, double age_years, KeptSounds kept = {},
                QObject* parent = nullptr);

    /// Another patient lies there from now on, or the same with another age.
    void startAfresh(double age_years);

    [[nodiscard]] const Numbers& numbers() const { return m_numbers; }
    /// The most urgent first; none while nothing is measured.
    [[nodiscard]] std::vector<VitalAlarms::Active> alarms() const;
    [[nodiscard]] const AlarmLimits& limits() const { return m_alarms.limits(); }
    /// Whether the alarms that there are, are silenced.
    [[nodiscard]] bool isSilenced() const;
    /// Silences the alarms that there are, for two minutes.
    void silenceAlarms();
    /// Whether the oximeter's tone sounds, or would: the mark that stands for it.
    [[nodiscard]] bool pulse() const;
    [[nodiscard]] const Heard& heard() const { return m_heard; }

    [[nodiscard]] KeptSounds::Loudness loudness(SoundKind kind) const { return m_kept.of(kind); }
    void setLoudness(SoundKind kind, const KeptSounds::Loudness& loudness);
    /// Whether no sound is played; what each kind has by itself is kept meanwhile.
    [[nodiscard]] bool isMuted() const { return m_kept.isMuted(); }
    void setMuted(bool isMuted);
    /// Whether a person can see the marks of the sounds; until it is told, they can.
    void setInSight(bool isInSight);
    /// What is to be played.
    [[nodiscard]] BedsideSounds& sounds() { return m_sounds; }

    /// Takes the samples that are due; a timer calls it.
    void look();

Q_SIGNALS:
    void sampled(const carina::VitalsModel::Sample& sample);
    /// The next sample is of another patient.
    void startedAfresh();
    /// Numbers, alarms, marks, loudness or mute changed.
    void changed();

private:
    void play(SoundKind kind);
    void playAll();
    void take(const Vitals& vitals, SessionTime t);
    void findBeats(const Vitals& vitals, SessionTime t);
    void rest();
    void sound(SessionTime t);
    void listen(const AuscultationGains& gains, const BreathFlows& flows, double step_s);
    void tellChange();
    [[nodiscard]] Numbers numbersOf(const Vitals& vitals) const;

    /// What was told by the last changed().
    struct Told {
        Numbers numbers{};
        std::vector<VitalAlarms::Active> alarms{};
        bool isSilenced = false;
        bool pulse = false;
        Heard heard{};

        friend bool operator==(const Told&, const Told&) = default;
    };

    VitalsSources m_sources;
    KeptSounds m_kept;
    VitalAlarms m_alarms;
    BedsideSounds m_sounds;
    bool m_isInSight = true;
    bool m_isMeasuring = false;
    Numbers m_numbers;
    Heard m_heard;
    std::optional<SessionTime> m_last;    ///< of the samples that were looked for
    std::optional<SessionTime> m_sounded; ///< when the sounds were set
    std::optional<SessionTime> m_pulsed;
    std::optional<SessionTime> m_beaten;
    PulseFinder m_pulseFinder;
    RisingEdge m_beatEdge;
    Told m_told;
};

} // namespace carina
