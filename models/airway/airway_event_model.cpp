#include "models/airway/airway_event_model.h"

#include "engine/core/expects.h"
#include "models/airway/airway_words.h"
#include "models/patient/session_patient.h"

#include <QTimer>

#include <algorithm>
#include <utility>

namespace carina
{
namespace
{

/// How often a change under way is looked for; nothing signals the moment a fact takes effect.
constexpr int kAirwayLook_ms = 50;
/// The airway is one thing of the patient, whichever of its events is changed.
constexpr std::size_t kAirway = 0;

double severityIn(const AirwayEvents& events, AirwayEventKind kind)
{
    const auto found = std::ranges::find(events, kind, &AirwayEvent::kind);
    return found == events.end() ? 0.0 : found->severity;
}

/// The same events but for one, which is left out where it has no severity.
AirwayEvents withSeverity(AirwayEvents events, AirwayEventKind kind, double severity)
{
    std::erase_if(events, [kind](const AirwayEvent& event) { return event.kind == kind; });
    if (severity > 0.0)
        events.insert(std::ranges::upper_bound(events, kind, {}, &AirwayEvent::kind),
                      {kind, severity});
    return events;
}

} // namespace

AirwayEventModel::AirwayEventModel(SessionModel& session, StationId station, QObject* parent)
    : QObject{parent}, m_session{session}, m_stations{station}
{
    connect(&m_session, &SessionModel::changed, this, &AirwayEventModel::refresh);
    auto* timer = new QTimer{this};
    connect(timer, &QTimer::timeout, this, &AirwayEventModel::refresh);
    timer->start(kAirwayLook_ms);
}

void AirwayEventModel::setStation(StationId station)
{
    if (std::exchange(m_stations.shown, station) == station)
        return;
    if (m_latest) // what waits goes now
        propose(*m_latest);
    m_latest.reset();
    m_sent.reset();
    refresh();
    Q_EMIT changed();
}

void AirwayEventModel::setForAll(bool all)
{
    if (std::exchange(m_stations.all, all) != all)
        Q_EMIT changed();
}

void AirwayEventModel::setPatient(const SessionPatient& patient)
{
    m_patient = &patient;
    refresh();
}

double AirwayEventModel::severity(AirwayEventKind kind) const { return severityIn(events(), kind); }

double AirwayEventModel::present(AirwayEventKind kind) const
{
    return severityIn(presentEvents(), kind);
}

bool AirwayEventModel::canBeSet(AirwayEventKind kind) const
{
    return m_stations.all || m_limits.canShow(kind) || severity(kind) > 0.0;
}

void AirwayEventModel::setSeverity(AirwayEventKind kind, double severity)
{
    setEvents(withSeverity(events(), kind, severity));
}

QString AirwayEventModel::inForceText() const { return eventsText(presentEvents()); }

QString AirwayEventModel::travellingText() const
{
    return pending() ? textOf(pending()->events) : QString{};
}

QString AirwayEventModel::textOf(const AirwayEvents& events)
{
    return tr("Airway → %1").arg(eventsText(events));
}

SessionTime AirwayEventModel::now() const { return m_session.node().now().value_or(SessionTime{}); }

AirwayEvents AirwayEventModel::presentEvents() const
{
    const auto state = m_session.node().state();
    const auto station = state->stations().find(m_stations.shown);
    return station == state->stations().end() ? AirwayEvents{}
                                              : station->second.airwayEvents.at(now());
}

AirwayEvents AirwayEventModel::decidedAt(StationId id, SessionTime t) const
{
    const auto state = m_session.node().state();
    const auto station = state->stations().find(id);
    return station == state->stations().end() ? AirwayEvents{}
                                              : station->second.airwayEvents.decidedAt(t);
}

const std::optional<AirwayEventModel::Setting>& AirwayEventModel::pending() const
{
    return m_latest ? m_latest : m_sent;
}

AirwayEvents AirwayEventModel::events() const
{
    return pending() ? pending()->events : decidedAt(m_stations.shown, now());
}

/// What a change would replace, at the shown station also what is under way; an undo has no time.
std::vector<AirwayEventModel::Setting> AirwayEventModel::before() const
{
    std::vector<Setting> settings;
    for (const StationId id : stationsOf(*m_session.node().state(), m_stations.target()))
        settings.push_back(
            {id, id == m_stations.shown ? events() : decidedAt(id, SessionTime::max()), {}});
    return settings;
}

void AirwayEventModel::setEvents(const AirwayEvents& events)
{
    CARINA_EXPECTS(areProper(events));
    const std::vector<Setting> replaced = before();
    const auto isSo = [&](const Setting& at) { return at.events == events; };
    if (std::ranges::all_of(replaced, isSo) || !obstacle().isEmpty())
        return;
    // A drag is one change: only its first step is what undo goes back to.
    const Setting wanted{m_stations.target(), events, m_over};
    if (pending() && m_steps.lastIsAbout(kAirway, wanted.station))
        m_steps.goOn(wanted, textOf(events));
    else
        m_steps.add(kAirway, wanted, replaced, textOf(events),
                    [this](const auto& step) { goBackTo(step.before); });
    ask(wanted);
}

void AirwayEventModel::undo()
{
    if (const auto step = m_steps.takeLast())
        goBackTo(step->before);
}

void AirwayEventModel::goBackTo(const std::vector<Setting>& before)
{
    for (const Setting& at : before)
        if (at.station == m_stations.shown)
            ask(at);
        else
            propose(at);
}

void AirwayEventModel::ask(const Setting& setting)
{
    if (m_sent) {
        m_latest = setting;
    } else {
        m_sent = setting;
        propose(setting);
    }
    Q_EMIT changed();
}

void AirwayEventModel::propose(const Setting& setting)
{
    m_session.node().propose(setting.station, fact::AirwayEventsSet{setting.events, setting.over});
}

bool AirwayEventModel::isUnderWay(const AirwayEvents& sent) const
{
    if (decidedAt(m_stations.shown, now()) == sent)
        return false; // in force, though the severities may still change
    if (!m_session.node().pending().empty())
        return true; // the host has not answered yet
    // Decided for later, unless the host refused it or somebody decided otherwise since.
    return decidedAt(m_stations.shown, SessionTime::max()) == sent;
}

bool AirwayEventModel::isDecided(StationId station, const AirwayEvents& events) const
{
    return m_session.node().state()->isOpen(station)
           && decidedAt(station, SessionTime::max()) == events;
}

/// From a change that is in force, or was not taken, to the one that waits.
void AirwayEventModel::goOn()
{
    if (!m_sent || isUnderWay(m_sent->events))
        return;
    m_sent.reset();
    if (const auto next = std::exchange(m_latest, std::nullopt))
        ask(*next);
}

void AirwayEventModel::lookAtPatient()
{
    if (!m_patient)
        return;
    const PatientModel& patient = *m_patient->patient();
    if (!liesAt(*m_session.node().state(), m_stations.shown, patient)) {
        m_limits = {};
        m_limitsOf.reset();
    } else if (m_limitsOf != patient.contentHash()) {
        m_limits = airwayLimitsOf(patient);
        m_limitsOf = patient.contentHash();
    }
}

void AirwayEventModel::refresh()
{
    goOn();
    lookAtPatient();
    if (m_session.node().pending().empty())
        m_steps.dropOverruled([this](const auto& step, StationId station) {
            return m_sent.has_value() || isDecided(station, step.set.events);
        });
    Shown shownNow{events(),   presentEvents(), pending().has_value(),
                   obstacle(), canUndo(),       m_limits};
    if (std::exchange(m_shown, shownNow) != shownNow)
        Q_EMIT changed();
}

} // namespace carina
