#pragma once

#include "engine/session/facts/fact_store.h"

#include <QSqlDatabase>

#include <map>
#include <span>

namespace carina
{

/// Everything in a store.
struct StoreContent {
    std::vector<FactRecord> facts; ///< in order, from number 1
    std::optional<ClockAnchor> anchor{};
    std::map<ObjectId, EventCpo> actions{};
};

// The rows of a store. Each has a column with the checkDigest of its other values. Readers return
// StoreCorrupt, with the row in the detail, where it does not match; all return StoreFailed where
// SQLite fails.

/// Creates the tables of a new store. @pre a transaction is open.
[[nodiscard]] Result<void> createRows(const QSqlDatabase& database);

/// All facts. @returns StoreCorrupt also where a number is missing.
[[nodiscard]] Result<std::vector<FactRecord>> readFacts(const QSqlDatabase& database);
/// Appends facts in one transaction. @returns StoreFailed also for one that is not the next.
[[nodiscard]] Result<void> insertFacts(const QSqlDatabase& database,
                                       std::span<const FactRecord> facts);

[[nodiscard]] Result<std::optional<ClockAnchor>> readAnchor(const QSqlDatabase& database);
[[nodiscard]] Result<void> writeAnchor(const QSqlDatabase& database, const ClockAnchor& anchor);

[[nodiscard]] Result<std::vector<EventCpo>> readActions(const QSqlDatabase& database);
/// Stores actions in one transaction.
[[nodiscard]] Result<void> writeActions(const QSqlDatabase& database,
                                        std::span<const EventCpo> events);

[[nodiscard]] Result<StoreContent> readContent(const QSqlDatabase& database);
/// Into an empty store, in one transaction.
[[nodiscard]] Result<void> writeContent(const QSqlDatabase& database, const StoreContent& content);

} // namespace carina
