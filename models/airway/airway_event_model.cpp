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
    : QObject{parent}, m_session{session}, m_changes{session, station, *this, quantities()}
{
    connect(&m_session, &SessionModel::changed, this, &AirwayEventModel::refresh);
    auto* timer = new QTimer{this};
    connect(timer, &QTimer::timeout, this, &AirwayEventModel::refresh);
    timer->start(kAirwayLook_ms);
}

AirwayEventModel::Changes::Quantities AirwayEventModel::quantities()
{
    return {
        .decidedAt =
            [this](StationId id, std::size_t /*airway*/, SessionTime t) {
                const auto state = m_session.node().state();
                const auto station = state->stations().find(id);
                return station == state->stations().end()
                           ? AirwayEvents{}
                           : station->second.airwayEvents.decidedAt(t);
            },
        .propose =
            [this](std::size_t /*airway*/, const Changes::Setting& setting) {
                m_session.node().propose(setting.station,
                                         fact::AirwayEventsSet{setting.value, setting.over});
            },
        .textOf = [](std::size_t /*airway*/, const AirwayEvents& events) { return textOf(events); },
        .requested = [this] { Q_EMIT changed(); }};
}

void AirwayEventModel::setStation(StationId station)
{
    if (!m_changes.setStation(station))
        return;
    refresh();
    Q_EMIT changed();
}

void AirwayEventModel::setForAll(bool all)
{
    if (m_changes.stations().all == all)
        return;
    m_changes.setForAll(all);
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
    return m_changes.stations().all || m_limits.canShow(kind) || severity(kind) > 0.0;
}

void AirwayEventModel::setSeverity(AirwayEventKind kind, double severity)
{
    setEvents(withSeverity(events(), kind, severity));
}

QString AirwayEventModel::inForceText() const { return eventsText(presentEvents()); }

QString AirwayEventModel::travellingText() const
{
    const auto& pending = m_changes.pending(kAirway);
    return pending ? textOf(pending->value) : QString{};
}

QString AirwayEventModel::textOf(const AirwayEvents& events)
{
    return tr("Airway → %1").arg(eventsText(events));
}

AirwayEvents AirwayEventModel::presentEvents() const
{
    const auto state = m_session.node().state();
    const auto station = state->stations().find(m_changes.stations().shown);
    const SessionTime now = m_session.node().now().value_or(SessionTime{});
    return station == state->stations().end() ? AirwayEvents{}
                                              : station->second.airwayEvents.at(now);
}

void AirwayEventModel::setEvents(const AirwayEvents& events)
{
    CARINA_EXPECTS(areProper(events));
    if (obstacle().isEmpty())
        m_changes.set(kAirway, events, m_over);
}

void AirwayEventModel::lookAtPatient()
{
    if (!m_patient)
        return;
    const PatientModel& patient = *m_patient->patient();
    if (!liesAt(*m_session.node().state(), m_changes.stations().shown, patient)) {
        m_limits = {};
        m_limitsOf.reset();
    } else if (m_limitsOf != patient.contentHash()) {
        m_limits = airwayLimitsOf(patient);
        m_limitsOf = patient.contentHash();
    }
}

void AirwayEventModel::refresh()
{
    m_changes.follow();
    lookAtPatient();
    Shown shownNow{events(),   presentEvents(), m_changes.pending(kAirway).has_value(),
                   obstacle(), canUndo(),       m_limits};
    if (std::exchange(m_shown, shownNow) != shownNow)
        Q_EMIT changed();
}

} // namespace carina
