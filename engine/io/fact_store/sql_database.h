#pragma once

#include "engine/core/result.h"

#include <QSqlDatabase>
#include <QSqlQuery>
#include <QVariant>

#include <initializer_list>

namespace carina
{

/// The error of SQLite, with the file in its detail.
[[nodiscard]] Error storeError(const QString& path, const QSqlError& error);

/// Runs one statement.
[[nodiscard]] Result<QSqlQuery> executeSql(const QSqlDatabase& database, const QString& sql,
                                           std::initializer_list<QVariant> values = {});

/// Opens the file of a session's store for exclusive use, and creates a new store where the file is
/// empty or does not exist. @returns as openFactStore
[[nodiscard]] Result<void> prepareStore(QSqlDatabase& database);

} // namespace carina
