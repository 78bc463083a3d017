#pragma once

#include "engine/core/result.h"

#include <QSqlDatabase>
#include <QSqlQuery>
#include <QVariant>

#include <initializer_list>

namespace carina
{

/// What SQLite objected to, with the file it is about.
[[nodiscard]] Error storeError(const QString& path, const QSqlError& error);

/// Runs one statement.
[[nodiscard]] Result<QSqlQuery> executeSql(const QSqlDatabase& database, const QString& sql,
                                           std::initializer_list<QVariant> values = {});

/// Opens the file of a session's store for this program alone, and begins a new one where it is
/// empty or not there. @returns as openFactStore
[[nodiscard]] Result<void> prepareStore(QSqlDatabase& database);

} // namespace carina
