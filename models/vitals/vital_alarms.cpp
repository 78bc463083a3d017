#include "models/vitals/vital_alarms.h"

#include "engine/core/expects.h"

#include <algorithm>

namespace carina
{
namespace
{

constexpr double kSaturationBack = 0.01;
constexpr Frequency kRateBack = perMinute(2.0);
constexpr Pressure kPressureBack = mmHg(3.0);
constexpr double kGrown_years = 18.0;
constexpr double kFirstWeek_years = 7.0 / 365.0;

/// 1st and 99th centile of heart rate up to an age (Fleming et al. 2011), per minute. Those of
/// birth are taken for the first week.
struct RateCentiles {
    double before_years;
    double first;
    double ninetyNinth;
};
constexpr std::array kRateCentiles{RateCentiles{kFirstWeek_years, 90, 164},
                                   RateCentiles{0.25, 107, 181},
                                   RateCentiles{0.5, 104, 175},
                                   RateCentiles{0.75, 98, 168},
                                   RateCentiles{1.0, 93, 161},
                                   RateCentiles{1.5, 88, 156},
                                   RateCentiles{2.0, 82, 149},
                                   RateCentiles{3.0, 76, 142},
                                   RateCentiles{4.0, 70, 136},
                                   RateCentiles{6.0, 65, 131},
                                   RateCentiles{8.0, 59, 123},
                                   RateCentiles{12.0, 52, 115},
                                   RateCentiles{15.0, 47, 108},
                                   RateCentiles{kGrown_years, 43, 104}};

Pressure lowestSystolic(double age_years)
{
    constexpr double kNewborn_years = 1.0 / 12.0;
    if (age_years < kNewborn_years)
        return mmHg(60.0);
    return age_years < 1.0 ? mmHg(70.0) : mmHg(std::min(90.0, 70.0 + 2.0 * age_years));
}

bool isBelow(double value, double limit, double back, bool isKept)
{
    return value < (isKept ? limit + back : limit);
}

bool isAbove(double value, double limit, double back, bool isKept)
{
    return isBelow(-value, -limit, back, isKept);
}

} // namespace

AlarmLimits alarmLimits(double age_years)
{
    CARINA_EXPECTS(age_years >= 0.0);
    AlarmLimits limits;
    const auto centiles =
        std::find_if(kRateCentiles.begin(), kRateCentiles.end(),
                     [age_years](const RateCentiles& c) { return age_years < c.before_years; });
    if (centiles != kRateCentiles.end()) {
        limits.slowHeart = perMinute(centiles->first);
        limits.fastHeart = perMinute(centiles->ninetyNinth);
    }
    limits.lowSystolic = lowestSystolic(age_years);
    limits.highSystolic = mmHg(std::min(160.0, 100.0 + 4.0 * age_years));
    if (age_years < 1.0)
        limits.apnoea = std::chrono::seconds{15};
    return limits;
}

void VitalAlarms::take(const Vitals& vitals, SessionTime t)
{
    CARINA_EXPECTS(!m_last || t >= *m_last);
    if (!m_last) // who comes late has not seen it
        m_sinceBreath_s = vitals.sinceBreath_s;
    const double step_s = m_last ? toSeconds(t - *m_last) : 0.0;
    m_last = t;
    const double observed_s = step_s > kLongestStep_s ? 0.0 : step_s;
    observe(vitals, observed_s);
    for (const VitalAlarm alarm : kVitalAlarms)
        judge(alarm, vitals, observed_s);
}

void VitalAlarms::observe(const Vitals& vitals, double step_s)
{
    if (m_sinceBreath_s)
        *m_sinceBreath_s += step_s;
    if (m_breath.take(vitals.exhaledCO2.value_or(Pressure{}).si))
        m_sinceBreath_s = 0.0;
    m_hadProbe = m_hadProbe || vitals.probeIsOn;
}

void VitalAlarms::judge(VitalAlarm alarm, const Vitals& vitals, double step_s)
{
    State& state = m_states[static_cast<std::size_t>(alarm)];
    const auto wanted = asked(alarm, vitals, false);
    state.now = std::min(state.now, asked(alarm, vitals, true)); // nothing is least
    if (wanted <= state.now) {
        state.rising_s = 0.0;
        return;
    }
    state.rising_s += step_s;
    if (alarm != VitalAlarm::Apnoea && state.rising_s < kDelay_s)
        return;
    state.now = wanted;
    state.rising_s = 0.0;
    m_silentUntil = SessionTime::min();
}

/// What an alarm would be at once. @param isKept while it is there already: it goes later than it
/// came
std::optional<AlarmPriority> VitalAlarms::asked(VitalAlarm alarm, const Vitals& vitals,
                                                bool isKept) const
{
    const auto high = [](bool holds) {
        return holds ? std::optional{AlarmPriority::High} : std::nullopt;
    };
    switch (alarm) {
    case VitalAlarm::NoHeartbeat:
        return high(vitals.heartRate.si <= 0.0);
    case VitalAlarm::Apnoea:
        return high(m_sinceBreath_s && *m_sinceBreath_s >= toSeconds(m_limits.apnoea));
    case VitalAlarm::LowSaturation: {
        const double shown = std::round(100.0 * vitals.saturation.value_or(1.0)) / 100.0;
        if (isBelow(shown, m_limits.veryLowSaturation, kSaturationBack, isKept))
            return AlarmPriority::High;
        return isBelow(shown, m_limits.lowSaturation, kSaturationBack, isKept)
                   ? std::optional{AlarmPriority::Medium}
                   : std::nullopt;
    }
    case VitalAlarm::SlowHeart:
    case VitalAlarm::FastHeart:
        return askedOfHeart(alarm, vitals.heartRate, isKept);
    case VitalAlarm::LowPressure:
    case VitalAlarm::HighPressure:
        return askedOfPressure(alarm, vitals.systolic, isKept);
    case VitalAlarm::NoProbe:
        break;
    }
    return m_hadProbe && !vitals.probeIsOn ? std::optional{AlarmPriority::Low} : std::nullopt;
}

/// A heart without any beat has an alarm of its own.
std::optional<AlarmPriority> VitalAlarms::askedOfHeart(VitalAlarm alarm, Frequency rate,
                                                       bool isKept) const
{
    if (rate.si <= 0.0)
        return std::nullopt;
    if (alarm == VitalAlarm::FastHeart)
        return isAbove(rate.si, m_limits.fastHeart.si, kRateBack.si, isKept)
                   ? std::optional{AlarmPriority::Medium}
                   : std::nullopt;
    if (isBelow(rate.si, kVeryLow * m_limits.slowHeart.si, kRateBack.si, isKept))
        return AlarmPriority::High;
    return isBelow(rate.si, m_limits.slowHeart.si, kRateBack.si, isKept)
               ? std::optional{AlarmPriority::Medium}
               : std::nullopt;
}

std::optional<AlarmPriority> VitalAlarms::askedOfPressure(VitalAlarm alarm, Pressure systolic,
                                                          bool isKept) const
{
    if (alarm == VitalAlarm::HighPressure)
        return isAbove(systolic.si, m_limits.highSystolic.si, kPressureBack.si, isKept)
                   ? std::optional{AlarmPriority::Medium}
                   : std::nullopt;
    if (isBelow(systolic.si, kVeryLow * m_limits.lowSystolic.si, kPressureBack.si, isKept))
        return AlarmPriority::High;
    return isBelow(systolic.si, m_limits.lowSystolic.si, kPressureBack.si, isKept)
               ? std::optional{AlarmPriority::Medium}
               : std::nullopt;
}

std::vector<VitalAlarms::Active> VitalAlarms::active() const
{
    std::vector<Active> active;
    for (const VitalAlarm alarm : kVitalAlarms)
        if (const auto priority = m_states[static_cast<std::size_t>(alarm)].now)
            active.push_back({alarm, *priority});
    std::stable_sort(active.begin(), active.end(),
                     [](const Active& a, const Active& b) { return a.priority > b.priority; });
    return active;
}

std::optional<AlarmPriority> VitalAlarms::audible(SessionTime t) const
{
    const auto all = active();
    return all.empty() || isSilenced(t) ? std::nullopt : std::optional{all.front().priority};
}

} // namespace carina
