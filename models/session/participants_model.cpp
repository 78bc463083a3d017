#include "models/session/participants_model.h"

#include "models/network/network_figures.h"
#include "models/site/standing_words.h"
#include "models/text/shown_as_is.h"

#include <QTimer>

#include <algorithm>
#include <span>

namespace carina
{
namespace
{

constexpr int kRefreshInterval_ms = 500;
constexpr Duration kReplacementTold = std::chrono::minutes{1};
/// Less than this nobody sees, whatever the delay allows.
constexpr double kUnseen_deg = 0.1;
constexpr double kUnseen_mm = 1.0;
const QString kNothing = QStringLiteral("–");

QString roleText(Role role)
{
    switch (role) {
    case Role::Instructor:
        return ParticipantsModel::tr("Instructor");
    case Role::Trainee:
        return ParticipantsModel::tr("Trainee");
    case Role::Observer:
        return ParticipantsModel::tr("Observer");
    }
    return {};
}

QString stationName(const SessionState& state, StationId station)
{
    const auto found = state.stations().find(station);
    return found == state.stations().end() ? kNothing : QString::fromStdString(found->second.name);
}

/// Where somebody is; of this program's own participant, which may look at any station, that it is
/// their place.
QString placeText(const SessionState& state, const Participant& who, bool isSelf)
{
    const QString name = stationName(state, who.station);
    const auto open = std::ranges::count_if(state.stations(),
                                            [](const auto& entry) { return !entry.second.closed; });
    return isSelf && open > 1 ? ParticipantsModel::tr("%1 (your place)", "a station").arg(name)
                              : name;
}

/// The number in place of %1.
QString number(const std::optional<double>& value, int decimals, const QString& words)
{
    return value ? words.arg(*value, 0, 'f', decimals) : kNothing;
}

void keepLargest(std::optional<double>& largest, std::optional<double> value)
{
    largest = std::max(largest, value); // none is less than any
}

} // namespace

ParticipantsModel::ParticipantsModel(SessionModel& session, QObject* parent)
    : QAbstractTableModel{parent}, m_session{session}
{
    connect(&m_session, &SessionModel::changed, this, &ParticipantsModel::refresh);
    auto* timer = new QTimer{this};
    connect(timer, &QTimer::timeout, this, &ParticipantsModel::refresh);
    timer->start(kRefreshInterval_ms);
    m_rows = currentRows();
}

std::optional<double> ParticipantsModel::oldestSample_ms() const
{
    std::optional<double> oldest;
    for (const Row& row : m_rows)
        if (row.age_ms)
            keepLargest(oldest, *row.age_ms);
    return oldest;
}

bool ParticipantsModel::hasRegistrations() const
{
    return std::ranges::any_of(m_rows, [](const Row& row) { return row.registration.has_value(); });
}

int ParticipantsModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int ParticipantsModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant ParticipantsModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    const Row& row = m_rows[std::size_t(index.row())];
    if (role == Qt::DisplayRole)
        return cell(row, index.column());
    if (role == Qt::AccessibleTextRole)
        return spoken(row, index.column());
    if (role == kIdRole)
        return uint{row.id.value};
    if (role == Qt::ToolTipRole && index.column() == State && !row.reason.isEmpty())
        return shownAsIs(row.reason);
    if (role == Qt::ToolTipRole && index.column() == Registration && row.registration)
        return shownAsIs(registrationTip(*row.registration));
    if (role == Qt::ToolTipRole && index.column() == Same)
        return shownAsIs(sameTip(row));
    if (role == Qt::AccessibleDescriptionRole && index.column() == Same)
        return sameTip(row);
    if (role == Qt::ToolTipRole && index.column() == Name)
        return shownAsIs(row.name);
    if (role == Qt::TextAlignmentRole && index.column() >= Sends && index.column() <= Delay)
        return int{Qt::AlignRight | Qt::AlignVCenter};
    return {};
}

QString ParticipantsModel::registrationTip(const RegistrationStanding& registration)
{
    const QString notice = standingNotice(registration);
    if (!notice.isEmpty())
        return notice;
    if (registration.state == RegistrationState::NoTracker)
        return tr("Their program has no tracker any more");
    return registration.state == RegistrationState::Simulated
               ? tr("A simulated manikin, registered without error")
               : tr("Verified. In 95 of 100 cases the error at the glottis is less than this");
}

/// Angle, distance, age and size, and what bounds them.
QString ParticipantsModel::figuresText(const Row& row)
{
    const QString places =
        tr("Off by %1 (bound %2) and %3 (bound %4); newest sample %5 old", "degrees; mm; ms")
            .arg(cell(row, DriftAngle), number(row.bound_deg, 2, tr("%1°")),
                 cell(row, DriftDistance), number(row.bound_mm, 1, tr("%1 mm")), cell(row, Age));
    if (!row.drift_percent)
        return places;
    return tr("%1; size off by %2 (bound %3)")
        .arg(places, number(row.drift_percent, 1, tr("%1 %")),
             number(row.bound_percent, 1, tr("%1 %")));
}

QString ParticipantsModel::sameText(const Row& row)
{
    if (row.seesTheSame)
        return *row.seesTheSame ? tr("✓ same") : tr("▲ differs");
    if (!row.isCompared)
        return kNothing;
    return row.owns ? tr("◇ unknown") : tr("○ none");
}

QString ParticipantsModel::sameTip(const Row& row)
{
    if (row.seesTheSame)
        return figuresText(row);
    if (!row.isCompared)
        return {};
    return row.owns ? tr("Their objects were not compared yet")
                    : tr("Shares no tool and nothing else whose place could be compared");
}

QString ParticipantsModel::cell(const Row& row, int column)
{
    switch (column) {
    case Name:
        return row.name;
    case RoleColumn:
        return row.role;
    case Station:
        return row.station;
    case State:
        return row.state;
    case Registration:
        return row.registration ? standingText(*row.registration) : kNothing;
    case Sends:
        return number(row.sends_kB_per_s, 1, tr("%1 kB/s"));
    case Age:
        return number(row.age_ms, 0, tr("%1 ms"));
    case DriftAngle:
        return number(row.drift_deg, 2, tr("%1°"));
    case DriftDistance:
        return number(row.drift_mm, 1, tr("%1 mm"));
    case Delay:
        return number(row.delay_ms, 0, tr("%1 ms"));
    case Same:
        return sameText(row);
    default:
        return {};
    }
}

QString ParticipantsModel::spoken(const Row& row, int column) const
{
    QString words = cell(row, column);
    if (words == kNothing)
        words = column == Registration ? tr("none") : tr("unknown");
    else if (column == State || column == Registration || column == Same)
        words = words.section(QLatin1Char(' '), 1);
    return headerData(column, Qt::Horizontal, Qt::DisplayRole).toString() + QStringLiteral(": ")
           + words;
}

QVariant ParticipantsModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::ToolTipRole) {
        if (section == Station)
            return tr("The station where the participant is: their tools, and what an instructor "
                      "shows to others, are there, whichever station this window shows");
        if (section == Registration)
            return tr("How far the registration of the participant's manikin can be relied on");
        if (section == Sends)
            return tr("What the participant's program sends to this one, without encryption and "
                      "headers of the network");
        if (section == Age)
            return tr("Age of the newest pose sample; of several objects, that of the oldest");
        if (section == DriftAngle)
            return tr("Drift: angle between what was shown here and at the participant at the same "
                      "time");
        if (section == Delay)
            return tr("Time that data take between the participant and this program, one way");
        if (section == Same)
            return tr("Whether the participant sees their tools and other objects where this "
                      "program shows them, but for what delay and tracker explain; figures in the "
                      "tool tip of each");
        if (section == DriftDistance)
            return tr("Drift: distance between what was shown here and at the participant at the "
                      "same time");
        return {};
    }
    if (role != Qt::DisplayRole)
        return {};
    switch (section) {
    case Name:
        return tr("Name");
    case RoleColumn:
        return tr("Role");
    case Station:
        return tr("Station");
    case State:
        return tr("State");
    case Registration:
        return tr("Registration");
    case Sends:
        return tr("Sends");
    case Age:
        return tr("Age");
    case DriftAngle:
        return tr("Drift °");
    case DriftDistance:
        return tr("Drift mm");
    case Delay:
        return tr("Delay");
    case Same:
        return tr("Objects");
    default:
        return {};
    }
}

void ParticipantsModel::refresh()
{
    std::vector<Row> rows = currentRows();
    if (rows == m_rows)
        return;
    const auto sameId = [](const Row& a, const Row& b) { return a.id == b.id; };
    if (std::ranges::equal(rows, m_rows, sameId)) {
        m_rows = std::move(rows);
        Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
        return;
    }
    // Numbers grow, so whoever is new stands below: the chosen row stays chosen.
    const int before = rowCount();
    if (rows.size() > m_rows.size()
        && std::ranges::equal(m_rows, std::span{rows}.first(m_rows.size()), sameId)) {
        beginInsertRows({}, before, static_cast<int>(rows.size()) - 1);
        m_rows = std::move(rows);
        endInsertRows();
        if (before > 0)
            Q_EMIT dataChanged(index(0, 0), index(before - 1, ColumnCount - 1));
        return;
    }
    beginResetModel();
    m_rows = std::move(rows);
    endResetModel();
}

std::vector<ParticipantsModel::Row> ParticipantsModel::currentRows() const
{
    const SessionNode& node = m_session.node();
    const auto state = node.state();
    const std::vector<ObjectReport> reports = node.objectReports();
    const auto paths = node.paths();
    const std::vector<LinkReport> links = node.links();
    const std::vector<NetworkFigures> figures = networkFigures(node);
    std::vector<Row> rows;
    for (const auto& [id, participant] : state->participants()) {
        Row row{.id = id,
                .name = QString::fromStdString(participant.name),
                .role = roleText(participant.role),
                .station = placeText(*state, participant, id == node.self()),
                .state = stateText(participant, links)};
        if (participant.present && state->atWork(participant.station) == id)
            row.role = tr("%1, at work").arg(row.role);
        if (participant.removal && !participant.present)
            row.reason =
                tr("Removed by %1")
                    .arg(QString::fromStdString(removalText(*state, *participant.removal)));
        if (participant.present)
            row.registration = participant.registration;
        const auto path = std::ranges::find(*paths, id, &PathReport::peer);
        if (path != paths->end() && path->traffic)
            row.sends_kB_per_s = 1e-3 * path->traffic->bytesPerSecond;
        for (const ObjectReport& report : reports) {
            const auto object = state->objects().find(report.object);
            // Of who is muted nothing is taken, so that what is known of their objects says
            // nothing.
            if (!participant.present || participant.muted || object == state->objects().end()
                || object->second.owner != id)
                continue;
            keepLargest(row.age_ms, 1e3 * toSeconds(report.age));
            keepLargest(row.drift_deg, report.driftDeg);
            keepLargest(row.drift_mm, report.driftMm);
        }
        if (participant.present && !participant.muted) {
            row.isCompared = id != node.self();
            row.owns = std::ranges::any_of(state->objects(), [owner = id](const auto& entry) {
                return entry.second.owner == owner;
            });
            addNetwork(figures, row);
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

void ParticipantsModel::addNetwork(const std::vector<NetworkFigures>& figures, Row& row)
{
    const auto found = std::ranges::find(figures, row.id, &NetworkFigures::id);
    if (found == figures.end())
        return;
    row.delay_ms = found->meanDelay_ms;
    for (const ObjectFigures& object : found->objects) {
        if (!object.drift_deg || !object.drift_mm)
            continue;
        keepLargest(row.bound_deg, object.same.deg);
        keepLargest(row.bound_mm, object.same.mm);
        keepLargest(row.drift_percent, object.drift_percent);
        if (object.drift_percent)
            keepLargest(row.bound_percent, object.same.percent);
        const bool isSame = *object.drift_deg <= object.same.deg
                            && *object.drift_mm <= object.same.mm
                            && object.drift_percent.value_or(0.0) <= object.same.percent;
        row.seesTheSame = row.seesTheSame.value_or(true) && isSame;
    }
}

QString ParticipantsModel::stateText(const Participant& participant,
                                     std::span<const LinkReport> links) const
{
    if (participant.id == m_session.node().self())
        return tr("✓ here");
    if (!participant.present)
        return absenceText(participant);
    const auto link = std::ranges::find(links, participant.id, &LinkReport::peer);
    switch (link != links.end() ? link->state : LinkState::Away) {
    case LinkState::Connected:
        if (participant.muted)
            return tr("▲ muted");
        return participant.tokenReplaced ? tr("▲ token replaced") : tr("✓ connected");
    case LinkState::Connecting:
        return tr("◇ connecting");
    case LinkState::Away:
    case LinkState::Ended:
        break;
    }
    return tr("▲ away");
}

QString ParticipantsModel::absenceText(const Participant& participant)
{
    if (!participant.removal)
        return participant.fellSilent ? tr("▲ away") : tr("○ left");
    return participant.removal->banned ? tr("✕ banned") : tr("○ may return");
}

} // namespace carina
