#include "models/station/stations_model.h"

#include "engine/anatomy/patient/patient_name.h"
#include "engine/core/expects.h"
#include "engine/session/facts/fact_rules.h"
#include "engine/session/facts/plain_name.h"
#include "engine/session/participant_limits.h"
#include "models/errors/error_text.h"
#include "models/patient/new_patient.h"

#include <algorithm>
#include <utility>

namespace carina
{
namespace
{

std::vector<StationsModel::Row> openStations(const SessionState& state)
{
    std::vector<StationsModel::Row> rows;
    for (const auto& [id, station] : state.stations()) {
        if (station.closed)
            continue;
        const auto present =
            std::ranges::count_if(state.participants(), [at = id](const auto& entry) {
                return entry.second.present && entry.second.station == at;
            });
        rows.push_back({id, QString::fromStdString(station.name), static_cast<int>(present)});
    }
    return rows;
}

} // namespace

StationsModel::StationsModel(SessionModel& session, QObject* parent)
    : QObject{parent}, m_session{session}, m_shown{ownStation(session.node())}
{
    connect(&m_session, &SessionModel::changed, this, &StationsModel::refresh);
    refresh();
}

void StationsModel::show(StationId station)
{
    const bool isOpen = std::ranges::find(m_open, station, &Row::id) != m_open.end();
    if (isOpen && std::exchange(m_shown, station) != station)
        Q_EMIT shownChanged(station);
}

void StationsModel::setForAll(bool all)
{
    m_forAll = all;
    tellForAll();
}

void StationsModel::tellForAll()
{
    if (std::exchange(m_toldForAll, isForAll()) != isForAll())
        Q_EMIT forAllChanged(isForAll());
}

QString StationsModel::nameOf(StationId station) const
{
    const auto state = m_session.node().state();
    const auto found = state->stations().find(station);
    return found == state->stations().end() ? QString{}
                                            : QString::fromStdString(found->second.name);
}

StationId StationsModel::stationOf(ParticipantId participant) const
{
    return m_session.node().state()->stationOf(participant);
}

QString StationsModel::obstacleToAdding() const
{
    if (m_session.phase() == SessionPhase::Ended)
        return tr("The session has ended.");
    const bool isEnough = m_open.size() >= kMostStations
                          || m_session.node().state()->stations().size() >= kMostStationsEver;
    return isEnough ? errorText({Errc::StationCount, {}}) : QString{};
}

QString StationsModel::obstacleToClosing(StationId station) const
{
    if (m_session.phase() == SessionPhase::Ended)
        return tr("The session has ended.");
    if (m_open.size() < 2)
        return tr("This is the only station that is open.");
    QStringList there;
    const auto state = m_session.node().state();
    for (const auto& [id, participant] : state->participants())
        if (participant.present && participant.station == station && id != m_session.node().self())
            there += QString::fromStdString(participant.name);
    return there.isEmpty() ? QString{}
                           : tr("Move these to another station first: %1.")
                                 .arg(there.join(QStringLiteral(", ")));
}

QString StationsModel::faultOfName(const QString& name, StationId self) const
{
    const std::string wanted = name.trimmed().toStdString();
    if (wanted.empty())
        return tr("Type a name.");
    if (wanted.size() > kLongestText)
        return tr("Type a shorter name.");
    const auto state = m_session.node().state();
    for (const auto& [id, station] : state->stations())
        if (id != self && !station.closed && lookAlike(station.name, wanted))
            return tr("“%1” looks the same: type another name.")
                .arg(QString::fromStdString(station.name));
    return checkName(wanted) ? QString{} : tr("Type a name without characters that are not seen.");
}

QString StationsModel::faultOfPatient(const QString& patient)
{
    return patientFromWords(patient.toStdString())
               ? QString{}
               : tr("Type adult, child, or figures such as: 45 years, 182 cm, man.");
}

void StationsModel::add(const QString& name, const QString& patient, After after)
{
    const auto parameters = patientFromWords(patient.toStdString());
    CARINA_EXPECTS(parameters.has_value());
    const QString plain = name.trimmed();
    m_opened.push_back({plain, *parameters, after});
    m_session.node().propose(kNoStation, fact::StationAdded{plain.toStdString()});
}

void StationsModel::rename(StationId station, const QString& name)
{
    m_session.node().propose(station, fact::StationRenamed{name.trimmed().toStdString()});
}

void StationsModel::close(StationId station)
{
    SessionNode& node = m_session.node();
    const auto other =
        std::ranges::find_if(m_open, [station](const Row& row) { return row.id != station; });
    if (other == m_open.end())
        return;
    if (ownStation(node) == station)
        move(node.self(), other->id);
    node.propose(station, fact::StationClosed{});
}

void StationsModel::move(ParticipantId participant, StationId station)
{
    m_session.node().propose(station, fact::ParticipantMoved{participant});
}

void StationsModel::refresh()
{
    std::vector<Row> open = openStations(*m_session.node().state());
    if (std::exchange(m_open, open) != open)
        Q_EMIT changed();
    tellForAll();
    layPatients();
    const bool isShownOpen = std::ranges::find(m_open, m_shown, &Row::id) != m_open.end();
    if (!isShownOpen && !m_open.empty())
        show(m_open.front().id);
}

/// At the stations that this program opened, once they are there.
void StationsModel::layPatients()
{
    SessionNode& node = m_session.node();
    for (Opened& opened : std::exchange(m_opened, {})) {
        const auto row = std::ranges::find(m_open, opened.name, &Row::name);
        if (row == m_open.end()) {
            m_opened.push_back(std::move(opened));
            continue;
        }
        layNewPatient(node, row->id, opened.patient);
        if (opened.after == After::ShowIt)
            show(row->id);
    }
}

} // namespace carina
