#include "models/respiration/breath_trace.h"

#include <QTimer>

namespace carina
{
namespace
{

constexpr int kTraceInterval_ms = 40;

/// The last multiple of the sampling interval at or before t.
SessionTime sampleBefore(SessionTime t)
{
    const auto since = t.time_since_epoch();
    const auto whole = since / BreathTrace::kSampleEvery;
    return SessionTime{BreathTrace::kSampleEvery * whole};
}

} // namespace

BreathTrace::BreathTrace(SessionModel& session, StationId station, QObject* parent)
    : QObject{parent}, m_session{session}, m_station{station}
{
    auto* timer = new QTimer{this};
    connect(timer, &QTimer::timeout, this, &BreathTrace::sample);
    timer->start(kTraceInterval_ms);
}

void BreathTrace::sample()
{
    const auto now = m_session.node().now();
    const auto state = m_session.node().state();
    const auto station = state->stations().find(m_station);
    if (!now || station == state->stations().end())
        return;
    const SessionTime end = sampleBefore(*now);
    SessionTime next = m_last ? *m_last + kSampleEvery : end;
    if (end - next > kLongestGap)
        next = end;
    for (; next <= end; next += kSampleEvery) {
        if (station->second.respiration.runsAt(next))
            take(m_breathing.at(station->second.respiration, next), next);
        m_last = next;
    }
}

void BreathTrace::take(const RespirationRun& run, SessionTime t)
{
    const RespiratoryFold& fold = run.fold();
    const Volume gas = fold.content()[0].gas + fold.content()[1].gas;
    const BreathTally& breath = fold.breath();
    if (breath.steps < m_breathSteps || m_breathBegan.si == 0.0) {
        m_breathBegan = breath.least[0] + breath.least[1]; // as far as is known
        m_wasVentilated = m_isVentilated;
    }
    m_isVentilated = fold.settings().ventilator.mode != VentilationMode::Spontaneous;
    m_breathSteps = breath.steps;
    m_figures = fold.lastBreath();
    Q_EMIT sampled({toSeconds(t.time_since_epoch()),
                    60.0 * inLitresPerSecond(fold.moment().airwayFlow),
                    inCmH2O(fold.moment().opening), inMillilitres(gas - m_breathBegan)});
}

std::optional<BreathTrace::Figures> BreathTrace::lastBreath() const
{
    if (m_figures.rate.si == 0.0)
        return std::nullopt;
    std::optional<Figures::Airway> airway;
    if (m_wasVentilated)
        airway = Figures::Airway{inCmH2O(m_figures.peak), inCmH2O(m_figures.plateau)};
    return Figures{inMillilitres(m_figures.tidalVolume),
                   inMillilitres(m_figures.tidalVolumeOfLung[0]),
                   inMillilitres(m_figures.tidalVolumeOfLung[1]),
                   inPerMinute(m_figures.rate),
                   airway,
                   inCmH2O(m_figures.autoPeep),
                   60.0 * inLitresPerSecond(m_figures.alveolarVentilation)};
}

} // namespace carina
