#include "models/vitals/vitals_model.h"

#include <QTimer>

#include <algorithm>
#include <cmath>
#include <utility>

namespace carina
{
namespace
{

constexpr int kVitalsInterval_ms = 20;
/// The R wave, millivolts: above what P and T waves reach in lead II.
constexpr RisingEdge kRWave{0.35, 0.5};
constexpr double kForgotten_perSecond = 1.0; ///< by how much what was heard fades on the screen
constexpr double kWheezes = 0.1;             ///< least obstruction that is told as wheezing
/// Loudness of the breath beneath it from which on a wheeze is told: it is high and carries
/// farther. Of ours; above what crosses the chest from the other lung in a quiet breath.
constexpr double kWheezeHeard = 0.015;

/// The last multiple of the sampling interval at or before t.
SessionTime vitalsSampleBefore(SessionTime t)
{
    return SessionTime{VitalsModel::kSampleEvery
                       * (t.time_since_epoch() / VitalsModel::kSampleEvery)};
}

int whole(double value) { return static_cast<int>(std::lround(value)); }

/// How loud a flow is as a share, as its sound is.
double loudnessOf(VolumeFlow flow)
{
    const double share = std::min(1.0, std::abs(flow / BreathSound::kFullFlow));
    return std::pow(share, BreathSound::kFlowExponent);
}

/// In tenths: what the screen shows of it.
double inSteps(double loudness) { return std::round(10.0 * loudness) / 10.0; }

} // namespace

VitalsModel::VitalsModel(VitalsSources sources, double age_years, KeptSounds kept, QObject* parent)
    : QObject{parent},
      m_sources{std::move(sources)},
      m_kept{std::move(kept)},
      m_alarms{alarmLimits(age_years)},
      m_beatEdge{kRWave}
{
    playAll();
    auto* timer = new QTimer{this};
    connect(timer, &QTimer::timeout, this, &VitalsModel::look);
    timer->start(kVitalsInterval_ms);
}

void VitalsModel::startAfresh(double age_years)
{
    m_alarms = VitalAlarms{alarmLimits(age_years)};
    m_last.reset();
    m_pulsed.reset();
    m_beaten.reset();
    m_pulseFinder = {};
    m_beatEdge = kRWave;
    rest();
    Q_EMIT startedAfresh();
    tellChange();
}

std::vector<VitalAlarms::Active> VitalsModel::alarms() const
{
    return m_isMeasuring ? m_alarms.active() : std::vector<VitalAlarms::Active>{};
}

bool VitalsModel::isSilenced() const { return m_last && m_alarms.isSilenced(*m_last); }

void VitalsModel::silenceAlarms()
{
    if (m_last)
        m_alarms.silence(*m_last);
    tellChange();
}

bool VitalsModel::pulse() const { return m_pulsed && *m_last - *m_pulsed < kPulseMark; }

void VitalsModel::setLoudness(SoundKind kind, const KeptSounds::Loudness& loudness)
{
    if (m_kept.of(kind) == loudness)
        return;
    m_kept.keep(kind, loudness);
    play(kind);
    Q_EMIT changed();
}

void VitalsModel::setMuted(bool isMuted)
{
    if (m_kept.isMuted() == isMuted)
        return;
    m_kept.keepMuted(isMuted);
    playAll();
    Q_EMIT changed();
}

void VitalsModel::setInSight(bool isInSight)
{
    if (std::exchange(m_isInSight, isInSight) != isInSight)
        playAll();
}

void VitalsModel::play(SoundKind kind)
{
    const KeptSounds::Loudness loudness = m_kept.of(kind);
    m_sounds.mixer().setVolume(kind, 0.01 * loudness.volume_percent);
    m_sounds.mixer().setMuted(kind, loudness.isMuted || m_kept.isMuted() || !m_isInSight);
}

void VitalsModel::playAll()
{
    for (const SoundKind kind : kSoundKinds)
        play(kind);
}

void VitalsModel::look()
{
    const auto now = m_sources.now();
    if (!now)
        return;
    const SessionTime end = vitalsSampleBefore(*now);
    SessionTime next = m_last ? *m_last + kSampleEvery : end;
    if (end - next > kLongestGap)
        next = end;
    for (; next <= end; next += kSampleEvery) {
        m_last = next;
        if (const auto vitals = m_sources.vitals(next))
            take(*vitals, next);
        else
            rest();
    }
    sound(end);
    tellChange();
}

void VitalsModel::take(const Vitals& vitals, SessionTime t)
{
    m_alarms.take(vitals, t);
    findBeats(vitals, t);
    Sample sample{toSeconds(t.time_since_epoch()), vitals.electrocardiogram};
    if (vitals.saturation)
        sample.pulse = vitals.pulseWave;
    if (vitals.exhaledCO2)
        sample.exhaledCO2_mmHg = inMmHg(*vitals.exhaledCO2);
    if (!std::exchange(m_isMeasuring, true)
        || t.time_since_epoch() % std::chrono::seconds{1} == Duration{})
        m_numbers = numbersOf(vitals);
    Q_EMIT sampled(sample);
}

void VitalsModel::findBeats(const Vitals& vitals, SessionTime t)
{
    if (vitals.saturation && m_pulseFinder.take(vitals.pulseWave, toSeconds(kSampleEvery))) {
        m_sounds.pulse(*vitals.saturation);
        m_pulsed = t;
    }
    if (m_beatEdge.take(vitals.electrocardiogram) && vitals.heartRate.si > 0.0) {
        m_sounds.beat(vitals.heartRate);
        m_beaten = t;
    }
}

VitalsModel::Numbers VitalsModel::numbersOf(const Vitals& vitals) const
{
    Numbers numbers;
    numbers.heartRate_perMin = whole(inPerMinute(vitals.heartRate));
    if (vitals.saturation)
        numbers.saturation_percent = whole(100.0 * *vitals.saturation);
    if (vitals.endTidalCO2) {
        const auto active = m_alarms.active();
        const bool isApnoea = std::any_of(active.begin(), active.end(), [](const auto& alarm) {
            return alarm.alarm == VitalAlarm::Apnoea;
        });
        numbers.endTidalCO2_mmHg = isApnoea ? 0 : whole(inMmHg(*vitals.endTidalCO2));
        numbers.respiratoryRate_perMin = isApnoea ? 0 : whole(inPerMinute(vitals.capnographRate));
    }
    numbers.pressure = BloodPressure{whole(inMmHg(vitals.systolic)),
                                     whole(inMmHg(vitals.diastolic)), whole(inMmHg(vitals.mean))};
    return numbers;
}

/// Nothing is measured.
void VitalsModel::rest()
{
    m_isMeasuring = false;
    m_numbers = {};
    m_heard = {};
    m_sounds.setAlarm(std::nullopt);
    m_sounds.setBreath({});
    m_sounds.setAuscultation({});
}

void VitalsModel::sound(SessionTime t)
{
    if (!m_isMeasuring)
        return;
    m_sounds.setAlarm(m_alarms.audible(t));
    const auto flows = m_sources.breath ? m_sources.breath(t) : std::nullopt;
    const auto gains = m_sources.stethoscope ? m_sources.stethoscope(t) : std::nullopt;
    m_sounds.setBreath(flows.value_or(BreathFlows{}));
    m_sounds.setAuscultation(gains.value_or(AuscultationGains{}));
    const double step_s = m_sounded ? toSeconds(t - *m_sounded) : 0.0;
    m_sounded = t;
    if (gains)
        listen(*gains, flows.value_or(BreathFlows{}), step_s);
    else
        m_heard = {};
}

/// What was loud a moment ago fades, so that a breath can be read.
void VitalsModel::listen(const AuscultationGains& gains, const BreathFlows& flows, double step_s)
{
    const auto hear = [step_s](double& kept, double loudness) {
        kept = std::max(loudness, std::max(0.0, kept - kForgotten_perSecond * step_s));
    };
    AuscultationGains& loud = m_heard.loudness;
    hear(loud.right, gains.right * loudnessOf(flows.right));
    hear(loud.left, gains.left * loudnessOf(flows.left));
    hear(loud.stomach, gains.stomach * loudnessOf(flows.stomach));
    hear(loud.trachea, gains.trachea * loudnessOf(flows.right + flows.left));
    const bool beats = m_beaten && *m_last - *m_beaten < kPulseMark;
    hear(loud.heart, beats ? gains.heart : 0.0);
    m_heard.isOnChest = gains != AuscultationGains{};
    m_heard.wheezes = (flows.rightObstruction > kWheezes && loud.right > kWheezeHeard)
                      || (flows.leftObstruction > kWheezes && loud.left > kWheezeHeard);
}

void VitalsModel::tellChange()
{
    Told told{m_numbers, alarms(), isSilenced(), pulse(), m_heard};
    for (double AuscultationGains::*place :
         {&AuscultationGains::right, &AuscultationGains::left, &AuscultationGains::stomach,
          &AuscultationGains::heart, &AuscultationGains::trachea})
        told.heard.loudness.*place = inSteps(told.heard.loudness.*place);
    if (told == m_told)
        return;
    m_told = std::move(told);
    Q_EMIT changed();
}

} // namespace carina
