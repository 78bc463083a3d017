#include "models/session/stored_sessions.h"

#include "engine/io/fact_store/sql_fact_store.h"
#include "engine/io/files/whole_file.h"
#include "engine/session/facts/fact_codec.h"
#include "engine/session/session_state.h"
#include "engine/session/station_rules.h"
#include "models/errors/error_text.h"
#include "models/text/shown_as_is.h"

#include <QDir>
#include <QLocale>

#include <algorithm>
#include <array>

namespace carina
{
namespace
{

const QString kSessionPattern = QStringLiteral("session-*.sqlite");
constexpr ParticipantId kHostOfStored{0};
constexpr FileLimit kReachLimit{"who could join a session", 64};

/// By SessionReach.
constexpr std::array kReachWords{"this-computer", "network", "by-link"};

std::filesystem::path reachFile(const QString& file)
{
    return std::filesystem::path{file.toStdString()}.replace_extension(".reach");
}

SessionReach keptReach(const QString& file)
{
    const auto word = readWholeFile(reachFile(file), kReachLimit);
    const auto known = word ? std::ranges::find(kReachWords, *word) : kReachWords.end();
    return known == kReachWords.end() ? SessionReach::ThisComputer
                                      : static_cast<SessionReach>(known - kReachWords.begin());
}

/// session-yyyyMMdd-hhmmss-zzz.sqlite, in UTC; a store that was moved has more behind it.
QDateTime beginningOf(const QString& file)
{
    const QString stamp = QFileInfo{file}.completeBaseName().section(QLatin1Char('-'), 1);
    QDateTime began = QDateTime::fromString(stamp.left(15), QStringLiteral("yyyyMMdd-hhmmss"));
    began.setTimeSpec(Qt::UTC);
    return began;
}

Result<SessionState> stateIn(const QString& file, SessionTime& last)
{
    const auto store = openFactStore(file.toStdString());
    if (!store)
        return tl::unexpected(store.error());
    const auto records = (*store)->load();
    if (!records)
        return tl::unexpected(records.error());
    SessionState state;
    for (const FactRecord& record : *records) {
        const auto fact = fromRecord(record);
        if (!fact)
            return tl::unexpected(fact.error());
        state.apply(*fact);
        last = std::max(last, fact->effect);
    }
    return state;
}

QString minutesText(Duration running)
{
    const auto minutes = std::chrono::floor<std::chrono::minutes>(running).count();
    return StoredSessionsModel::tr("%n minutes", nullptr, int(minutes));
}

QString sessionLine(const StoredSession& session)
{
    const QString began = QLocale{}.toString(session.began.toLocalTime(), QLocale::ShortFormat);
    if (!session.fault.isEmpty())
        return StoredSessionsModel::tr("▲ %1: %2").arg(began, session.fault);
    QStringList told{began, session.name, session.patient, minutesText(session.running)};
    if (!session.people.isEmpty())
        told += session.people.join(QStringLiteral(", "));
    told.removeAll(QString{});
    return told.join(QStringLiteral("  ·  "));
}

} // namespace

QStringList sessionFiles(const QString& folder)
{
    const QDir within{folder};
    QStringList files = within.entryList({kSessionPattern}, QDir::Files, QDir::Name);
    std::ranges::reverse(files);
    for (QString& file : files)
        file = within.filePath(file);
    return files;
}

void keepReach(const QString& file, SessionReach reach)
{
    static_cast<void>(
        writeWholeFile(reachFile(file), kReachWords.at(static_cast<std::size_t>(reach))));
}

StoredSession storedSession(const QString& file)
{
    StoredSession session{.file = file, .began = beginningOf(file), .reach = keptReach(file)};
    SessionTime last{};
    const auto state = stateIn(file, last);
    if (!state) {
        session.fault = errorText(state.error());
        return session;
    }
    session.name = QString::fromStdString(state->name());
    session.hasEnded = state->phaseAt(last) == SessionPhase::Ended;
    session.running = state->runningTime(last);
    const auto station = state->stations().find(firstOpenStation(*state));
    if (station != state->stations().end()) {
        session.patient = QString::fromStdString(station->second.anatomyName);
        session.anatomyHash = station->second.anatomyHash;
    }
    for (const auto& [id, participant] : state->participants())
        if (id != kHostOfStored)
            session.people += QString::fromStdString(participant.name);
    return session;
}

StoredSessionsModel::StoredSessionsModel(QString folder, QObject* parent)
    : QAbstractListModel{parent}, m_folder{std::move(folder)}
{
    m_reader.setMaxThreadCount(1);
    read();
}

StoredSessionsModel::~StoredSessionsModel() { stop(); }

void StoredSessionsModel::read()
{
    stop();
    beginResetModel();
    m_sessions.clear();
    m_isComplete = false;
    endResetModel();
    m_reader.start([this, run = m_run.load()] {
        for (const QString& file : sessionFiles(m_folder)) {
            if (m_run != run)
                return;
            tell(run, [this, session = storedSession(file)] { take(session); });
        }
        tell(run, [this] {
            m_isComplete = true;
            Q_EMIT completed();
        });
    });
}

/// What an earlier run found is not taken twice.
void StoredSessionsModel::tell(int run, std::function<void()> found)
{
    QMetaObject::invokeMethod(
        this,
        [this, run, found = std::move(found)] {
            if (m_run == run)
                found();
        },
        Qt::QueuedConnection);
}

void StoredSessionsModel::stop()
{
    ++m_run;
    m_reader.waitForDone();
}

int StoredSessionsModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_sessions.size());
}

QVariant StoredSessionsModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    if (role == Qt::ToolTipRole)
        return shownAsIs(sessionLine(at(index.row())));
    const bool isText = role == Qt::DisplayRole || role == Qt::AccessibleTextRole;
    return isText ? QVariant{sessionLine(at(index.row()))} : QVariant{};
}

Qt::ItemFlags StoredSessionsModel::flags(const QModelIndex& index) const
{
    if (!index.isValid() || !at(index.row()).fault.isEmpty())
        return Qt::NoItemFlags;
    return QAbstractListModel::flags(index);
}

const StoredSession& StoredSessionsModel::at(int row) const
{
    return m_sessions.at(static_cast<std::size_t>(row));
}

void StoredSessionsModel::take(const StoredSession& session)
{
    if (session.hasEnded)
        return;
    beginInsertRows({}, rowCount(), rowCount());
    m_sessions.push_back(session);
    endInsertRows();
}

} // namespace carina
