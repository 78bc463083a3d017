#include "models/airway/airway_event_model.h"

#include "engine/anatomy/events/airway_contents.h"
#include "engine/anatomy/events/throat_room.h"
#include "engine/core/expects.h"
#include "models/airway/airway_presets.h"
#include "models/patient/session_patient.h"

#include <algorithm>
#include <utility>

namespace carina
{
namespace
{

/// The same events but for one, which is left out where it has no severity.
AirwayEvents withSeverity(AirwayEvents events, AirwayEventKind kind, double severity)
{
    std::erase_if(events, [kind](const AirwayEvent& event) { return event.kind == kind; });
    if (severity > 0.0)
        events.insert(std::ranges::upper_bound(events, kind, {}, &AirwayEvent::kind),
                      {kind, severity});
    return events;
}

AirwayEvents withoutFluids(const AirwayEvents& events)
{
    AirwayEvents left = events;
    for (const AirwayEventKind kind : kThroatFluids)
        left = withSeverity(left, kind, 0.0);
    return left;
}

} // namespace

AirwayEventModel::AirwayEventModel(SessionModel& session, StationId station, QObject* parent)
    : GradualDecisionOf{session, station, howDecided(), parent}
{
}

AirwayEventModel::Kind AirwayEventModel::howDecided()
{
    return {
        .decidedAt = [](const Station& station,
                        SessionTime t) { return station.airwayEvents.decidedAt(t); },
        .presentAt = [](const Station& station,
                        SessionTime t) { return station.airwayEvents.at(t); },
        .overAt = [](const Station& station,
                     SessionTime t) { return station.airwayEvents.overAt(t); },
        .factOf = [](const AirwayEvents& events, Duration over) -> FactBody {
            return fact::AirwayEventsSet{events, over};
        },
        .textOf =
            [](const AirwayEvents& events) { return tr("Airway → %1").arg(airwayText(events)); }};
}

void AirwayEventModel::setForAll(bool all)
{
    if (stations().all == all)
        return;
    setAddressed(all);
    Q_EMIT changed();
}

void AirwayEventModel::setPatient(const SessionPatient& patient)
{
    m_patient = &patient;
    refresh();
}

double AirwayEventModel::severity(AirwayEventKind kind) const { return severityOf(events(), kind); }

double AirwayEventModel::present(AirwayEventKind kind) const
{
    return severityOf(presentValue(), kind);
}

double AirwayEventModel::drawn(AirwayEventKind kind) const
{
    const auto shows = [this, kind](AirwayEventKind each) {
        const bool comesAndGoes = each == AirwayEventKind::Swallowing && each != kind;
        return !comesAndGoes && m_limits.canShow(each);
    };
    return severityOf(asDrawn(presentValue(), shows), kind);
}

bool AirwayEventModel::canBeSet(AirwayEventKind kind) const
{
    return stations().all || m_limits.canShow(kind) || severity(kind) > 0.0;
}

void AirwayEventModel::setSeverity(AirwayEventKind kind, double severity)
{
    setEvents(withSeverity(events(), kind, severity));
}

bool AirwayEventModel::isAnywhere(bool (*is)(const AirwayEvents&)) const
{
    return std::ranges::any_of(
        stationsOf(*session().node().state(), stations().target()),
        [&](StationId id) { return is(wantedAt(id)) || is(presentValueAt(id)); });
}

bool AirwayEventModel::hasEvents() const
{
    return isAnywhere([](const AirwayEvents& events) { return !events.empty(); });
}

bool AirwayEventModel::hasFluid() const
{
    return isAnywhere([](const AirwayEvents& events) { return withoutFluids(events) != events; });
}

void AirwayEventModel::suction()
{
    requestEach(withoutFluids, kSuction, tr("Airway → suction of all fluids"));
}

QString AirwayEventModel::inForceText() const { return shortAirwayText(presentValue()); }

void AirwayEventModel::setEvents(const AirwayEvents& events)
{
    CARINA_EXPECTS(areProper(events));
    request(events);
}

bool AirwayEventModel::refreshMore()
{
    const bool hasEventsNow = hasEvents();
    const bool hasFluidNow = hasFluid();
    const bool isOther = std::exchange(m_hasEvents, hasEventsNow) != hasEventsNow;
    const bool isFluidOther = std::exchange(m_hasFluid, hasFluidNow) != hasFluidNow;
    return refreshLimits() || isOther || isFluidOther;
}

bool AirwayEventModel::refreshLimits()
{
    if (!m_patient)
        return false;
    const AirwayLimits before = m_limits;
    const PatientModel& patient = *m_patient->patient();
    if (!liesAt(*session().node().state(), stations().shown, patient)) {
        m_limits = {};
        m_limitsOf.reset();
    } else if (m_limitsOf != patient.contentHash()) {
        m_limits = airwayLimitsOf(patient);
        m_limitsOf = patient.contentHash();
    }
    return m_limits != before;
}

} // namespace carina
