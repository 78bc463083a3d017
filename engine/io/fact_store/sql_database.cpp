#include "engine/io/fact_store/sql_database.h"

#include <QFile>
#include <QFileInfo>
#include <QSqlError>

#include <string>

namespace carina
{

namespace
{

constexpr int kStoreApplicationId = 0x4352'4e41; // "CRNA", read by file(1) and by us
constexpr int kStoreVersion = 1;

// Stores of before there were actions have none.
const QString kActionTable =
    QStringLiteral("CREATE TABLE IF NOT EXISTS action (object INTEGER PRIMARY KEY,"
                   " cpo BLOB NOT NULL) STRICT");

Result<void> executeAll(const QSqlDatabase& database, std::initializer_list<QString> statements)
{
    for (const QString& sql : statements)
        if (const auto done = executeSql(database, sql); !done)
            return tl::unexpected(done.error());
    return {};
}

/// The first value of the first row.
Result<QVariant> readOne(const QSqlDatabase& database, const QString& sql)
{
    Result<QSqlQuery> query = executeSql(database, sql);
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

} // namespace

Error storeError(const QString& path, const QSqlError& error)
{
    static const QString kCorrupt = QStringLiteral("11");
    static const QString kNotADatabase = QStringLiteral("26");
    const QString code = error.nativeErrorCode();
    const bool corrupt = code == kCorrupt || code == kNotADatabase;
    return {corrupt ? Errc::StoreCorrupt : Errc::StoreFailed,
            (path + QStringLiteral(": ") + error.databaseText()).toStdString()};
}

Result<QSqlQuery> executeSql(const QSqlDatabase& database, const QString& sql,
                             std::initializer_list<QVariant> values)
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

Result<void> prepareStore(QSqlDatabase& database)
{
    const bool hasChangesBeside = QFile::exists(database.databaseName() + QStringLiteral("-wal"));
    database.setConnectOptions(QStringLiteral("QSQLITE_BUSY_TIMEOUT=1000"));
    if (!database.open())
        return tl::unexpected(storeError(database.databaseName(), database.lastError()));
    const auto lock = executeSql(database, QStringLiteral("PRAGMA locking_mode = EXCLUSIVE"));
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
        .and_then([&] { return isNew ? createSchema(database) : Result<void>{}; })
        .and_then([&] { return executeAll(database, {kActionTable}); });
}

} // namespace carina
