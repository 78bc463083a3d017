#include "engine/io/fact_store/sql_database.h"

#include <QSqlError>

#include <atomic>

namespace carina
{

Error storeError(const QString& path, const QSqlError& error)
{
    static const QString kCorrupt = QStringLiteral("11");
    static const QString kNotADatabase = QStringLiteral("26");
    const QString code = error.nativeErrorCode();
    const bool corrupt = code == kCorrupt || code == kNotADatabase;
    return {corrupt ? Errc::StoreCorrupt : Errc::StoreFailed,
            (path + QStringLiteral(": ") + error.databaseText()).toStdString()};
}

Result<QSqlQuery> prepareSql(const QSqlDatabase& database, const QString& sql)
{
    QSqlQuery query{database};
    query.setForwardOnly(true);
    if (!query.prepare(sql))
        return tl::unexpected(storeError(database.databaseName(), query.lastError()));
    return query;
}

Result<void> runSql(const QSqlDatabase& database, QSqlQuery& prepared,
                    std::initializer_list<QVariant> values)
{
    for (const QVariant& value : values)
        prepared.addBindValue(value);
    if (!prepared.exec())
        return tl::unexpected(storeError(database.databaseName(), prepared.lastError()));
    return {};
}

Result<QSqlQuery> executeSql(const QSqlDatabase& database, const QString& sql,
                             std::initializer_list<QVariant> values)
{
    return prepareSql(database, sql).and_then([&](QSqlQuery query) {
        return runSql(database, query, values).map([&] { return std::move(query); });
    });
}

Result<void> executeAll(const QSqlDatabase& database, std::initializer_list<QString> statements)
{
    for (const QString& sql : statements)
        if (const auto done = executeSql(database, sql); !done)
            return tl::unexpected(done.error());
    return {};
}

Result<void> inTransaction(const QSqlDatabase& database, const std::function<Result<void>()>& work)
{
    auto done = executeAll(database, {QStringLiteral("BEGIN IMMEDIATE")}).and_then(work);
    if (done)
        done = executeAll(database, {QStringLiteral("COMMIT")});
    if (!done) // fails where SQLite has rolled back by itself
        static_cast<void>(executeSql(database, QStringLiteral("ROLLBACK")));
    return done;
}

SqlConnection::SqlConnection(const QString& path)
{
    static std::atomic<int> count{0};
    m_name = QStringLiteral("carina fact store %1").arg(++count);
    QSqlDatabase database = QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), m_name);
    database.setDatabaseName(path);
    database.setConnectOptions(QStringLiteral("QSQLITE_BUSY_TIMEOUT=1000"));
}

SqlConnection::~SqlConnection() { QSqlDatabase::removeDatabase(m_name); }

} // namespace carina
