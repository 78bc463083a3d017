#include "models/station/stations_model.h"

#include "engine/anatomy/patient/patient_name.h"
#include "engine/core/expects.h"
#include "engine/session/facts/fact_rules.h"
#include "engine/session/facts/plain_name.h"
#include "engine/session/participant_limits.h"
#include "models/errors/error_text.h"
#include "models/objects/object_words.h"
#include "models/patient/new_patient.h"
#include "models/session/propose_back.h"
#include "models/session/proposed.h"

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

QString wholeNumber(double value) { return QString::number(value, 'f', 0); }

double inCentimetres(Length length) { return 0.1 * inMillimetres(length); }

/// One sentence for each figure that is out of its range, with that.
QStringList figuresOutOfRange(const PatientParameters& patient)
{
    QStringList faults;
    if (patient.ageInYears < kYoungest_years || patient.ageInYears > kOldest_years)
        faults += StationsModel::tr("%1 years are out of range: an age is %2 to %3 years.")
                      .arg(wholeNumber(patient.ageInYears), wholeNumber(kYoungest_years),
                           wholeNumber(kOldest_years));
    const LengthRange heights = heightRange(patient.ageInYears);
    if (patient.height < heights.least || patient.height > heights.most)
        faults += StationsModel::tr("%1 cm are out of range: a height is %2 to %3 cm.")
                      .arg(wholeNumber(inCentimetres(patient.height)),
                           wholeNumber(inCentimetres(heights.least)),
                           wholeNumber(inCentimetres(heights.most)));
    const auto usual = teethToCarinaRange(patient);
    if (!usual || !patient.teethToCarina)
        return faults;
    if (*patient.teethToCarina < usual->least || *patient.teethToCarina > usual->most)
        faults += StationsModel::tr("%1 mm are out of range: teeth to carina are %2 to %3 mm in a "
                                    "patient of this age, height and sex.")
                      .arg(wholeNumber(inMillimetres(*patient.teethToCarina)),
                           wholeNumber(inMillimetres(usual->least)),
                           wholeNumber(inMillimetres(usual->most)));
    return faults;
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
    if (!isOpen || std::exchange(m_shown, station) == station)
        return;
    tellHistory();
    Q_EMIT shownChanged(station);
}

void StationsModel::setHistory(ChangeHistory& history)
{
    m_history = &history;
    tellHistory();
}

void StationsModel::tellHistory()
{
    if (!m_history)
        return;
    std::map<StationId, QString> names;
    for (const Row& row : m_open)
        names.emplace(row.id, row.name);
    m_history->setStations(m_shown, std::move(names));
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
    const auto said = parametersFromWords(patient.toStdString());
    return said ? figuresOutOfRange(*said).join(QLatin1Char{' '})
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
    const QString given = name.trimmed();
    if (const QString before = nameOf(station); m_history && given != before)
        m_history->add(
            *this, tr("Name of the station → %1").arg(given),
            [this, station, before, given] { takeBackName(station, before, given); }, 0, station);
    m_session.node().propose(station, fact::StationRenamed{given.toStdString()});
}

void StationsModel::takeBackName(StationId station, const QString& before, const QString& given)
{
    const bool isUnderWay = isProposed<fact::StationRenamed>(
        m_session.node(), [&given](const fact::StationRenamed& proposed) {
            return proposed.name == given.toStdString();
        });
    proposeBack(m_session.node(), station, fact::StationRenamed{before.toStdString()},
                isUnderWay ? QString{} : whyNameStays(station, before, given), m_history);
}

/// Empty where the name can be taken back.
QString StationsModel::whyNameStays(StationId station, const QString& before,
                                    const QString& given) const
{
    const QString now = nameOf(station);
    if (!m_session.node().state()->isOpen(station))
        return tr("Not undone: the station %1 has been closed.").arg(now);
    if (now == before)
        return tr("Nothing to undo: the station is called %1 again.").arg(now);
    if (now != given)
        return tr("Not undone: somebody has called the station %1 since.").arg(now);
    return faultOfName(before, station).isEmpty()
               ? QString{}
               : tr("Not undone: another station is called %1 now.").arg(before);
}

void StationsModel::close(StationId station)
{
    SessionNode& node = m_session.node();
    const auto other =
        std::ranges::find_if(m_open, [station](const Row& row) { return row.id != station; });
    if (other == m_open.end())
        return;
    if (ownStation(node) == station)
        bring(node.self(), other->id);
    node.propose(station, fact::StationClosed{});
}

void StationsModel::bring(ParticipantId participant, StationId station)
{
    m_session.node().propose(station, fact::ParticipantMoved{participant});
}

void StationsModel::move(ParticipantId participant, StationId station)
{
    const auto state = m_session.node().state();
    if (const StationId from = state->stationOf(participant); m_history && from != station)
        m_history->add(
            *this,
            tr("%1 → moved to %2", "a participant; a station")
                .arg(participantWord(*state, participant), nameOf(station)),
            [this, participant, from, station] { takeBackMove(participant, from, station); });
    bring(participant, station);
}

void StationsModel::takeBackMove(ParticipantId participant, StationId from, StationId to)
{
    const bool isUnderWay = isProposed<fact::ParticipantMoved>(
        m_session.node(), [participant](const fact::ParticipantMoved& proposed) {
            return proposed.participant == participant;
        });
    proposeBack(m_session.node(), from, fact::ParticipantMoved{participant},
                isUnderWay ? QString{} : whyMoveStays(participant, from, to), m_history);
}

/// Empty where the participant can go back.
QString StationsModel::whyMoveStays(ParticipantId participant, StationId from, StationId to) const
{
    const auto state = m_session.node().state();
    const QString who = participantWord(*state, participant);
    const StationId now = state->stationOf(participant);
    if (!state->isPresent(participant))
        return tr("Not undone: %1 has left the session.").arg(who);
    if (now == from)
        return tr("Nothing to undo: %1 is at %2 again.", "a participant; a station")
            .arg(who, nameOf(now));
    if (now != to)
        return tr("Not undone: %1 is at %2 now.", "a participant; a station").arg(who, nameOf(now));
    return state->isOpen(from)
               ? QString{}
               : tr("Not undone: the station %1 has been closed.").arg(nameOf(from));
}

void StationsModel::refresh()
{
    std::vector<Row> open = openStations(*m_session.node().state());
    if (std::exchange(m_open, open) != open) {
        tellHistory();
        Q_EMIT changed();
    }
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
