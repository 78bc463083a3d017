#pragma once

#include "engine/audio/alarm_sound.h"
#include "engine/core/session_time.h"
#include "engine/physiology/vitals.h"
#include "models/vitals/rising_edge.h"

#include <array>
#include <optional>
#include <vector>

namespace carina
{

/// What a bedside monitor raises an alarm for.
enum class VitalAlarm : std::uint8_t {
    NoHeartbeat,
    Apnoea, ///< no exhaled CO2, after there was some
    LowSaturation,
    SlowHeart,
    FastHeart,
    LowPressure,
    HighPressure,
    NoProbe, ///< of the oximeter, after there was one
};
inline constexpr std::array kVitalAlarms{VitalAlarm::NoHeartbeat,   VitalAlarm::Apnoea,
                                         VitalAlarm::LowSaturation, VitalAlarm::SlowHeart,
                                         VitalAlarm::FastHeart,     VitalAlarm::LowPressure,
                                         VitalAlarm::HighPressure,  VitalAlarm::NoProbe};

/// Where alarms begin.
struct AlarmLimits {
    double lowSaturation = 0.90;     ///< medium priority below it
    double veryLowSaturation = 0.85; ///< high priority below it
    Frequency slowHeart = perMinute(50.0);
    Frequency fastHeart = perMinute(120.0);
    Pressure lowSystolic = mmHg(90.0);
    Pressure highSystolic = mmHg(160.0);
    Duration apnoea = std::chrono::seconds{20};

    friend bool operator==(const AlarmLimits&, const AlarmLimits&) = default;
};

/// The limits for a patient of an age.
///
/// Heart rate: below 18 years the 1st and 99th centile (Fleming et al., Lancet 2011;377:1011), 50
/// and 120 /min from then on. The heart of a newborn is slower than that of an infant of a month,
/// so those of birth, 90 and 164 /min, hold for the first week (of ours); the 2nd to 98th centile
/// of the first day, 96 to 162 /min (Tveiten et al., Arch Dis Child Fetal Neonatal Ed
/// 2021;106:489), lie within. Lowest systolic pressure: hypotension of the American Heart
/// Association's paediatric life support, 60 mmHg in the newborn, 70 in the first year, then 70 + 2
/// age, and 90 from ten years on. Of ours: the saturations, the grown person's rates, the time of
/// apnoea, 15 s in the first year and then 20 s, and the highest pressure, 100 mmHg at birth, 4
/// more a year, up to 160.
/// @pre age_years is 0 or more
[[nodiscard]] AlarmLimits alarmLimits(double age_years);

/// The alarms of a bedside monitor, from what it measures.
///
/// Saturations count as the whole per cent that are shown. An alarm begins, or becomes more urgent,
/// when its limit was passed for kDelay_s on end, and then has the urgency of the moment; it ends,
/// or becomes less urgent, once the value is back by a small distance (1 % of saturation,
/// 2 beats per minute, 3 mmHg; of ours). Apnoea begins after its own time and ends with a breath's
/// CO2; the last breath before the first moment counts, by the capnograph, which takes less CO2 for
/// a breath (kBreathAt_mmHg): with a tube in the oesophagus who comes late hears the alarm up to
/// two breaths later than the others. Time that is not observed, as during a pause, does not count.
class VitalAlarms
{
public:
    struct Active {
        VitalAlarm alarm{};
        AlarmPriority priority{};

        friend bool operator==(const Active&, const Active&) = default;
    };

    static constexpr double kDelay_s = 4.0; ///< of ours
    static constexpr Duration kSilence = std::chrono::minutes{2};
    /// A rise of exhaled CO2 through this is a breath: 1 kPa, the least amplitude of CO2 that
    /// counts as exhaled (PUMA 2022, as textbooks have it).
    static constexpr Pressure kBreathCO2 = mmHg(7.5);
    /// A heart rate or pressure below this share of its low limit is of high priority (of ours).
    static constexpr double kVeryLow = 0.8;
    /// Longer steps from one moment to the next are not observed time.
    static constexpr double kLongestStep_s = 1.0;

    explicit VitalAlarms(const AlarmLimits& limits) : m_limits{limits} {}

    [[nodiscard]] const AlarmLimits& limits() const { return m_limits; }

    /// The next moment. @pre t is not before the last one
    void take(const Vitals& vitals, SessionTime t);

    /// The most urgent first, and of one urgency in the order of the enumeration.
    [[nodiscard]] std::vector<Active> active() const;

    /// Silences the alarms that there are for kSilence. One that begins or becomes more urgent in
    /// the meantime is heard.
    void silence(SessionTime t) { m_silentUntil = t + kSilence; }
    /// Whether it is silenced, though nothing else may sound.
    [[nodiscard]] bool isSilenced(SessionTime t) const { return t < m_silentUntil; }
    /// What is to be heard.
    [[nodiscard]] std::optional<AlarmPriority> audible(SessionTime t) const;

private:
    struct State {
        std::optional<AlarmPriority> now;
        double rising_s = 0.0; ///< for how long more was asked than is now
    };

    [[nodiscard]] std::optional<AlarmPriority> asked(VitalAlarm alarm, const Vitals& vitals,
                                                     bool isKept) const;
    [[nodiscard]] std::optional<AlarmPriority> askedOfHeart(VitalAlarm alarm, Frequency rate,
                                                            bool isKept) const;
    [[nodiscard]] std::optional<AlarmPriority> askedOfPressure(VitalAlarm alarm, Pressure systolic,
                                                               bool isKept) const;
    void observe(const Vitals& vitals, double step_s);
    void judge(VitalAlarm alarm, const Vitals& vitals, double step_s);

    AlarmLimits m_limits;
    std::array<State, kVitalAlarms.size()> m_states;
    std::optional<SessionTime> m_last;
    SessionTime m_silentUntil = SessionTime::min();
    RisingEdge m_breath{0.5 * kBreathCO2.si, kBreathCO2.si};
    std::optional<double> m_sinceBreath_s; ///< nothing before the first one
    bool m_hadProbe = false;
};

} // namespace carina
