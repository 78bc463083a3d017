#include "engine/io/sql_fact_store.h"

#include <QFile>
#include <QFileInfo>
#include <QSqlDatabase>
#include <QSqlError>
#include <QSqlQuery>
#include <QVariant>

#include <atomic>
#include <initializer_list>
#include <limits>
#include <optional>
#include <span>
#include <thread>

namespace carina
{

namespace
{

constexpr int kStoreApplicationId = 0x4352'4e41; // "CRNA", read by file(1) and by us
constexpr int kStoreVersion = 1;

Error storeError(const QString& path, const QSqlError& error)
{
    static const QString kCorrupt = QStringLiteral("11");
    static const QString kNotADatabase = QStringLiteral("26");
    const QString code = error.nativeErrorCode();
    const bool corrupt = code == kCorrupt || code == kNotADatabase;
    return {corrupt ? Errc::StoreCorrupt : Errc::StoreFailed,
            (path + QStringLiteral(": ") + error.databaseText()).toStdString()};
}

Result<QSqlQuery> execute(const QSqlDatabase& database, const QString& sql,
                          std::initializer_list<QVariant> values = {})
{
    QSqlQuery query{database};
    query.setForwardOnly(true);
    const bool prepared = query.prepare(sql);
    for (const QVariant& value : values)
        query.addBindValue(value);
    if (!prepared || !query.exec())
        return tl::unexpected(storeError(database.databaseName(), query.lastError()));
    return query;
}

Result<void> executeAll(const QSqlDatabase& database, std::initializer_list<QString> statements)
{
    for (const QString& sql : statements)
        if (const auto done = execute(database, sql); !done)
            return tl::unexpected(done.error());
    return {};
}

/// The first value of the first row.
Result<QVariant> readOne(const QSqlDatabase& database, const QString& sql)
{
    Result<QSqlQuery> query = execute(database, sql);
    if (!query)
        return tl::unexpected(query.error());
    if (!query->next())
        return tl::unexpected(storeError(database.databaseName(), query->lastError()));
    return query->value(0);
}

Result<void> createSchema(QSqlDatabase& database)
{
    return executeAll(
        database,
        {QStringLiteral("BEGIN IMMEDIATE"),
         QStringLiteral("CREATE TABLE fact (number INTEGER PRIMARY KEY, proposal INTEGER NOT NULL,"
                        " author INTEGER NOT NULL, station INTEGER NOT NULL,"
                        " committed_ns INTEGER NOT NULL, effect_ns INTEGER NOT NULL,"
                        " body BLOB NOT NULL) STRICT"),
         QStringLiteral("CREATE TABLE clock_anchor (only INTEGER PRIMARY KEY CHECK (only = 0),"
                        " boot_id TEXT NOT NULL, offset_ns INTEGER NOT NULL) STRICT"),
         QStringLiteral("PRAGMA application_id = %1").arg(kStoreApplicationId),
         QStringLiteral("PRAGMA user_version = %1").arg(kStoreVersion), QStringLiteral("COMMIT")});
}

/// Whether the last page of the file is cut off; SQLite would read the rest of it as zeros.
Result<bool> isCutOff(const QSqlDatabase& database)
{
    const auto pageSize = readOne(database, QStringLiteral("PRAGMA page_size"));
    if (!pageSize)
        return tl::unexpected(pageSize.error());
    return QFileInfo{database.databaseName()}.size() % pageSize->toLongLong() != 0;
}

/// That the database is ours and whole. A file that a crash left with changes beside it, in its
/// -wal, may end in half a page, which they mend.
Result<void> checkSchema(const QSqlDatabase& database, bool hasChangesBeside)
{
    const std::string path = database.databaseName().toStdString();
    const auto application = readOne(database, QStringLiteral("PRAGMA application_id"));
    const auto version = readOne(database, QStringLiteral("PRAGMA user_version"));
    const auto check = readOne(database, QStringLiteral("PRAGMA quick_check(1)"));
    for (const auto* answer : {&application, &version, &check})
        if (!*answer)
            return tl::unexpected(answer->error());
    if (application->toInt() != kStoreApplicationId)
        return fail(Errc::UnknownFormat, path);
    if (version->toInt() != kStoreVersion)
        return fail(Errc::UnknownFormat, path + ": version " + std::to_string(version->toInt()));
    if (check->toString() != QStringLiteral("ok"))
        return fail(Errc::StoreCorrupt, path + ": " + check->toString().toStdString());
    const Result<bool> cutOff = isCutOff(database);
    if (!cutOff)
        return tl::unexpected(cutOff.error());
    if (*cutOff && !hasChangesBeside)
        return fail(Errc::StoreCorrupt, path + ": cut off");
    return {};
}

Result<void> prepare(QSqlDatabase& database)
{
    const bool hasChangesBeside = QFile::exists(database.databaseName() + QStringLiteral("-wal"));
    database.setConnectOptions(QStringLiteral("QSQLITE_BUSY_TIMEOUT=1000"));
    if (!database.open())
        return tl::unexpected(storeError(database.databaseName(), database.lastError()));
    const auto lock = execute(database, QStringLiteral("PRAGMA locking_mode = EXCLUSIVE"));
    if (!lock)
        return tl::unexpected(lock.error());
    const auto tables = readOne(database, QStringLiteral("SELECT count(*) FROM sqlite_master"));
    if (!tables)
        return tl::unexpected(tables.error());
    const bool isNew = tables->toInt() == 0;
    if (!isNew)
        if (const Result<void> checked = checkSchema(database, hasChangesBeside); !checked)
            return checked;
    return executeAll(database, {QStringLiteral("PRAGMA journal_mode = WAL"),
                                 QStringLiteral("PRAGMA synchronous = FULL")})
        .and_then([&] { return isNew ? createSchema(database) : Result<void>{}; });
}

template <class Number> bool fits(qint64 value)
{
    return value >= 0 && value <= qint64{std::numeric_limits<Number>::max()};
}

/// The fact in a row of load's query; nothing where a value is out of its range.
std::optional<FactRecord> readFact(const QSqlQuery& row)
{
    const qint64 author = row.value(2).toLongLong();
    const qint64 station = row.value(3).toLongLong();
    const QByteArray body = row.value(6).toByteArray();
    if (!fits<std::uint16_t>(author) || !fits<std::uint16_t>(station)
        || std::size_t(body.size()) > kLargestFactBody)
        return std::nullopt;
    const auto bytes = std::as_bytes(std::span{body.constData(), std::size_t(body.size())});
    return FactRecord{FactNumber{row.value(0).toULongLong()},
                      ProposalId{std::uint64_t(row.value(1).toLongLong())},
                      ParticipantId{std::uint16_t(author)},
                      StationId{std::uint16_t(station)},
                      SessionTime{Duration{row.value(4).toLongLong()}},
                      SessionTime{Duration{row.value(5).toLongLong()}},
                      {bytes.begin(), bytes.end()}};
}

/// Keeps one connection, of the thread that used it last: Qt ties a connection to its thread.
class SqlFactStore final : public FactStore
{
public:
    explicit SqlFactStore(QString path) : m_path{std::move(path)} {}
    SqlFactStore(const SqlFactStore&) = delete;
    SqlFactStore& operator=(const SqlFactStore&) = delete;
    ~SqlFactStore() override { close(); }

    /// The connection of this thread.
    Result<QSqlDatabase> connection()
    {
        if (m_thread == std::this_thread::get_id())
            return QSqlDatabase::database(m_name, false);
        close();
        static std::atomic<int> count{0};
        m_name = QStringLiteral("carina fact store %1").arg(++count);
        QSqlDatabase database = QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), m_name);
        database.setDatabaseName(m_path);
        if (const Result<void> ready = prepare(database); !ready) {
            database = {};
            close();
            return tl::unexpected(ready.error());
        }
        m_thread = std::this_thread::get_id();
        return database;
    }

    Result<std::vector<FactRecord>> load() override
    {
        const Result<QSqlDatabase> database = connection();
        if (!database)
            return tl::unexpected(database.error());
        // A body that is too long is cut short before it is read, and then refused.
        Result<QSqlQuery> rows = execute(
            *database, QStringLiteral("SELECT number, proposal, author, station, committed_ns,"
                                      " effect_ns, substr(body, 1, %1) FROM fact ORDER BY number")
                           .arg(kLargestFactBody + 1));
        if (!rows)
            return tl::unexpected(rows.error());
        std::vector<FactRecord> facts;
        while (rows->next()) {
            std::optional<FactRecord> fact = readFact(*rows);
            if (!fact || fact->number.value != facts.size() + 1)
                return fail(Errc::StoreCorrupt,
                            m_path.toStdString() + ": fact " + std::to_string(facts.size() + 1));
            facts.push_back(*std::move(fact));
        }
        if (rows->lastError().isValid())
            return tl::unexpected(storeError(m_path, rows->lastError()));
        return facts;
    }

    Result<void> append(const FactRecord& fact) override
    {
        const Result<QSqlDatabase> database = connection();
        if (!database)
            return tl::unexpected(database.error());
        const qint64 number = qint64(fact.number.value);
        QByteArray body{""}; // empty is not NULL
        body.append(reinterpret_cast<const char*>(fact.body.data()), qsizetype(fact.body.size()));
        const Result<QSqlQuery> stored =
            execute(*database,
                    QStringLiteral("INSERT INTO fact SELECT ?, ?, ?, ?, ?, ?, ?"
                                   " WHERE ? = (SELECT ifnull(max(number), 0) + 1 FROM fact)"),
                    {number, qint64(fact.proposal.value), fact.author.value, fact.station.value,
                     qint64(fact.committed.time_since_epoch().count()),
                     qint64(fact.effect.time_since_epoch().count()), body, number});
        if (!stored)
            return tl::unexpected(stored.error());
        if (stored->numRowsAffected() != 1)
            return fail(Errc::StoreFailed, m_path.toStdString() + ": fact " + std::to_string(number)
                                               + " is not the next");
        return {};
    }

    Result<std::optional<ClockAnchor>> clockAnchor() override
    {
        const Result<QSqlDatabase> database = connection();
        if (!database)
            return tl::unexpected(database.error());
        Result<QSqlQuery> row =
            execute(*database, QStringLiteral("SELECT boot_id, offset_ns FROM clock_anchor"));
        if (!row)
            return tl::unexpected(row.error());
        if (row->next())
            return ClockAnchor{row->value(0).toString().toStdString(),
                               Duration{row->value(1).toLongLong()}};
        if (row->lastError().isValid())
            return tl::unexpected(storeError(m_path, row->lastError()));
        return std::nullopt;
    }

    Result<void> setClockAnchor(const ClockAnchor& anchor) override
    {
        const Result<QSqlDatabase> database = connection();
        if (!database)
            return tl::unexpected(database.error());
        const Result<QSqlQuery> stored = execute(
            *database, QStringLiteral("INSERT OR REPLACE INTO clock_anchor VALUES (0, ?, ?)"),
            {QString::fromStdString(anchor.bootId), qint64(anchor.offset.count())});
        if (!stored)
            return tl::unexpected(stored.error());
        return {};
    }

private:
    void close()
    {
        if (!m_name.isEmpty())
            QSqlDatabase::removeDatabase(m_name);
        m_name.clear();
        m_thread = {};
    }

    QString m_path;
    QString m_name; ///< of the connection; empty while there is none
    std::thread::id m_thread;
};

} // namespace

Result<std::unique_ptr<FactStore>> openFactStore(const std::filesystem::path& path)
{
    auto store = std::make_unique<SqlFactStore>(QFile::decodeName(path.c_str()));
    if (const auto opened = store->connection(); !opened)
        return tl::unexpected(opened.error());
    return store;
}

} // namespace carina
