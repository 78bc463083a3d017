#pragma once

#include "engine/core/result.h"

#include <QSqlDatabase>
#include <QSqlQuery>
#include <QVariant>

#include <functional>
#include <initializer_list>

namespace carina
{

/// The error of SQLite, with the file in its detail.
[[nodiscard]] Error storeError(const QString& path, const QSqlError& error);

/// A statement that is parsed once, to be run with other values again and again.
[[nodiscard]] Result<QSqlQuery> prepareSql(const QSqlDatabase& database, const QString& sql);
/// Runs it. @param values of its parameters, in their order
[[nodiscard]] Result<void> runSql(const QSqlDatabase& database, QSqlQuery& prepared,
                                  std::initializer_list<QVariant> values);

/// Prepares and runs one statement.
[[nodiscard]] Result<QSqlQuery> executeSql(const QSqlDatabase& database, const QString& sql,
                                           std::initializer_list<QVariant> values = {});

/// Runs several, up to the first that fails.
[[nodiscard]] Result<void> executeAll(const QSqlDatabase& database,
                                      std::initializer_list<QString> statements);

/// Runs `work` in a transaction, which is rolled back where it fails.
[[nodiscard]] Result<void> inTransaction(const QSqlDatabase& database,
                                         const std::function<Result<void>()>& work);

/// A connection of Qt to an SQLite file under a name of its own, for one thread.
class SqlConnection
{
public:
    explicit SqlConnection(const QString& path);
    SqlConnection(const SqlConnection&) = delete;
    SqlConnection& operator=(const SqlConnection&) = delete;
    ~SqlConnection();

    [[nodiscard]] QSqlDatabase database() const { return QSqlDatabase::database(m_name, false); }

private:
    QString m_name;
};

} // namespace carina
