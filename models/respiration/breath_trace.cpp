#include "models/respiration/breath_trace.h"

#include <QTimer>

#include <cmath>
#include <utility>

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

void BreathTrace::setStation(StationId station)
{
    if (std::exchange(m_station, station) == station)
        return;
    m_traced = {};
    Q_EMIT startedAfresh();
}

void BreathTrace::sample()
{
    const auto now = m_session.node().now();
    const auto state = m_session.node().state();
    const auto station = state->stations().find(m_station);
    if (!now || station == state->stations().end())
        return;
    const SessionTime end = sampleBefore(*now);
    SessionTime next = m_traced.last ? *m_traced.last + kSampleEvery : end;
    if (end - next > kLongestGap)
        next = end;
    for (; next <= end; next += kSampleEvery) {
        if (station->second.respiration.runsAt(next))
            take(m_traced.breathing.at(station->second.respiration, next), next);
        m_traced.last = next;
    }
}

void BreathTrace::take(const PatientRun& run, SessionTime t)
{
    const RespiratoryFold& fold = run.fold();
    const Volume gas = fold.content()[0].gas + fold.content()[1].gas;
    const BreathTally& breath = fold.breath();
    if (breath.steps < m_traced.breathSteps || m_traced.breathBegan.si == 0.0) {
        m_traced.breathBegan = breath.least[0] + breath.least[1]; // as far as is known
        m_traced.wasVentilated = m_traced.isVentilated;
        const ChestContent rest = restingContent(fold.system());
        m_traced.functionalResidual = rest[0].gas + rest[1].gas;
    }
    m_traced.isVentilated = fold.isVentilated();
    m_traced.isStill = fold.isStill();
    m_traced.breathSteps = breath.steps;
    m_traced.figures = fold.lastBreath();
    Q_EMIT sampled({toSeconds(t.time_since_epoch()),
                    60.0 * inLitresPerSecond(fold.moment().airwayFlow),
                    inCmH2O(fold.moment().opening), inMillilitres(gas - m_traced.breathBegan)});
}

std::optional<BreathTrace::Figures> BreathTrace::lastBreath() const
{
    if (m_traced.figures.rate.si == 0.0)
        return std::nullopt;
    std::optional<Figures::Airway> airway;
    if (m_traced.wasVentilated)
        airway = Figures::Airway{inCmH2O(m_traced.figures.peak), inCmH2O(m_traced.figures.plateau)};
    return Figures{inMillilitres(m_traced.figures.tidalVolume),
                   inMillilitres(m_traced.figures.tidalVolumeOfLung[0]),
                   inMillilitres(m_traced.figures.tidalVolumeOfLung[1]),
                   inPerMinute(m_traced.figures.rate),
                   airway,
                   inCmH2O(m_traced.figures.autoPeep),
                   60.0 * inLitresPerSecond(m_traced.figures.alveolarVentilation),
                   inMillilitres(m_traced.functionalResidual)};
}

BreathTrace::WholeBreath BreathTrace::inWhole(const Figures& breath)
{
    const int whole = qRound(breath.tidalVolume_ml);
    const double right = std::floor(breath.right_ml);
    const double left = std::floor(breath.left_ml);
    const int lacking = whole - int(right) - int(left);
    const bool rightLostMore = breath.right_ml - right > breath.left_ml - left;
    const int more = (lacking + 1) / 2; // 1 of 1; 1 each of 2
    const int toRight = rightLostMore ? more : lacking - more;
    return {whole, int(right) + toRight, int(left) + lacking - toRight};
}

} // namespace carina
