#include "engine/io/fact_store/fact_rows.h"

#include "engine/io/fact_store/sql_database.h"
#include "engine/io/files/check_digest.h"
#include "engine/sync/wire/cpo_codec.h"

#include <QSqlError>

#include <limits>
#include <span>

namespace carina
{
namespace
{

template <class Number> bool fits(qint64 value)
{
    return value >= 0 && value <= qint64{std::numeric_limits<Number>::max()};
}

qint64 nanoseconds(SessionTime time) { return time.time_since_epoch().count(); }

QByteArray qtBytes(std::span<const std::byte> bytes)
{
    QByteArray copy{""}; // empty is not NULL
    copy.append(reinterpret_cast<const char*>(bytes.data()), qsizetype(bytes.size()));
    return copy;
}

QByteArray factDigest(const FactRecord& fact)
{
    std::vector<std::byte> bytes;
    ByteWriter out{bytes};
    out.number(fact.number.value);
    out.number(fact.proposal.value);
    out.number(fact.author.value);
    out.number(fact.station.value);
    out.number(nanoseconds(fact.committed));
    out.number(nanoseconds(fact.effect));
    out.bytes(fact.body);
    return checkDigest(qtBytes(bytes));
}

QByteArray anchorDigest(const ClockAnchor& anchor)
{
    return checkDigest(QByteArray::number(qint64(anchor.offset.count())) + ' '
                       + QByteArray::fromStdString(anchor.bootId));
}

QByteArray actionBytes(const EventCpo& event)
{
    std::vector<std::byte> bytes;
    ByteWriter out{bytes};
    writeEventCpo(out, event);
    return qtBytes(bytes);
}

tl::unexpected<Error> corrupt(const QSqlDatabase& database, const std::string& row)
{
    return fail(Errc::StoreCorrupt, database.databaseName().toStdString() + ": " + row);
}

/// The fact in a row; nothing where a value is out of its range.
std::optional<FactRecord> factIn(const QSqlQuery& row)
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

// The action in a row; nothing where it is none.
std::optional<EventCpo> actionIn(const QByteArray& cpo)
{
    ByteReader in{std::as_bytes(std::span{cpo.constData(), std::size_t(cpo.size())})};
    const EventCpo event = readEventCpo(in);
    return in.ok() && in.remaining() == 0 ? std::optional{event} : std::nullopt;
}

ClockAnchor anchorIn(const QSqlQuery& row)
{
    return {row.value(0).toString().toStdString(), Duration{row.value(1).toLongLong()}};
}

// What is too long is cut short before it is read, and then refused.
QString selectFacts()
{
    return QStringLiteral("SELECT number, proposal, author, station, committed_ns, effect_ns,"
                          " substr(body, 1, %1), digest FROM fact ORDER BY number")
        .arg(kLargestFactBody + 1);
}

QString selectActions()
{
    return QStringLiteral("SELECT object, substr(cpo, 1, %1), digest FROM action")
        .arg(kEventCpoBytes + 1);
}

/// Calls `take(row)` for every row until one fails.
template <class Take>
Result<void> forEachRow(const QSqlDatabase& database, const QString& sql, const Take& take)
{
    Result<QSqlQuery> rows = executeSql(database, sql);
    if (!rows)
        return tl::unexpected(rows.error());
    while (rows->next())
        if (const Result<void> taken = take(*rows); !taken)
            return taken;
    if (rows->lastError().isValid())
        return tl::unexpected(storeError(database.databaseName(), rows->lastError()));
    return {};
}

Result<void> done(const Result<QSqlQuery>& query)
{
    return query.map([](const QSqlQuery&) {});
}

/// Calls `store(item)` for every item until one fails.
template <class Items, class Store> Result<void> forEach(const Items& items, const Store& store)
{
    for (const auto& item : items)
        if (const Result<void> stored = store(item); !stored)
            return stored;
    return {};
}

Result<void> insertFact(QSqlQuery& insert, const QSqlDatabase& database, const FactRecord& fact)
{
    const qint64 number = qint64(fact.number.value);
    const Result<void> stored =
        runSql(database, insert,
               {number, qint64(fact.proposal.value), fact.author.value, fact.station.value,
                nanoseconds(fact.committed), nanoseconds(fact.effect), qtBytes(fact.body),
                factDigest(fact), number});
    if (!stored)
        return stored;
    if (insert.numRowsAffected() != 1)
        return fail(Errc::StoreFailed, database.databaseName().toStdString() + ": fact "
                                           + std::to_string(number) + " is not the next");
    return {};
}

/// @pre a transaction is open.
Result<void> insertEach(const QSqlDatabase& database, std::span<const FactRecord> facts)
{
    return prepareSql(database,
                      QStringLiteral("INSERT INTO fact SELECT ?, ?, ?, ?, ?, ?, ?, ?"
                                     " WHERE ? = (SELECT ifnull(max(number), 0) + 1 FROM fact)"))
        .and_then([&](QSqlQuery insert) {
            return forEach(
                facts, [&](const FactRecord& fact) { return insertFact(insert, database, fact); });
        });
}

Result<void> writeAction(const QSqlDatabase& database, const EventCpo& event)
{
    const QByteArray cpo = actionBytes(event);
    return done(executeSql(database,
                           QStringLiteral("INSERT OR REPLACE INTO action VALUES (?, ?,"
                                          " ?)"),
                           {event.object.value, cpo, checkDigest(cpo)}));
}

} // namespace

Result<void> createRows(const QSqlDatabase& database)
{
    return executeAll(
        database,
        {QStringLiteral("CREATE TABLE fact (number INTEGER PRIMARY KEY, proposal INTEGER NOT NULL,"
                        " author INTEGER NOT NULL, station INTEGER NOT NULL,"
                        " committed_ns INTEGER NOT NULL, effect_ns INTEGER NOT NULL,"
                        " body BLOB NOT NULL, digest BLOB NOT NULL) STRICT"),
         QStringLiteral("CREATE TABLE clock_anchor (only INTEGER PRIMARY KEY CHECK (only = 0),"
                        " boot_id TEXT NOT NULL, offset_ns INTEGER NOT NULL,"
                        " digest BLOB NOT NULL) STRICT"),
         QStringLiteral("CREATE TABLE action (object INTEGER PRIMARY KEY, cpo BLOB NOT NULL,"
                        " digest BLOB NOT NULL) STRICT")});
}

Result<std::vector<FactRecord>> readFacts(const QSqlDatabase& database)
{
    std::vector<FactRecord> facts;
    return forEachRow(database, selectFacts(),
                      [&](const QSqlQuery& row) -> Result<void> {
                          auto fact = factIn(row);
                          if (!fact || fact->number.value != facts.size() + 1
                              || row.value(7).toByteArray() != factDigest(*fact))
                              return corrupt(database, "fact " + std::to_string(facts.size() + 1));
                          facts.push_back(*std::move(fact));
                          return {};
                      })
        .map([&] { return std::move(facts); });
}

Result<void> insertFacts(const QSqlDatabase& database, std::span<const FactRecord> facts)
{
    return inTransaction(database, [&] { return insertEach(database, facts); });
}

Result<std::optional<ClockAnchor>> readAnchor(const QSqlDatabase& database)
{
    std::optional<ClockAnchor> anchor;
    return forEachRow(database,
                      QStringLiteral("SELECT boot_id, offset_ns, digest FROM clock_anchor"),
                      [&](const QSqlQuery& row) -> Result<void> {
                          anchor = anchorIn(row);
                          if (row.value(2).toByteArray() != anchorDigest(*anchor))
                              return corrupt(database, "the clock");
                          return {};
                      })
        .map([&] { return anchor; });
}

Result<void> writeAnchor(const QSqlDatabase& database, const ClockAnchor& anchor)
{
    return done(executeSql(database,
                           QStringLiteral("INSERT OR REPLACE INTO clock_anchor VALUES (0, ?, ?,"
                                          " ?)"),
                           {QString::fromStdString(anchor.bootId), qint64(anchor.offset.count()),
                            anchorDigest(anchor)}));
}

Result<std::vector<EventCpo>> readActions(const QSqlDatabase& database)
{
    std::vector<EventCpo> actions;
    return forEachRow(database, selectActions(),
                      [&](const QSqlQuery& row) -> Result<void> {
                          const QByteArray cpo = row.value(1).toByteArray();
                          const auto event = actionIn(cpo);
                          if (!event || row.value(0).toLongLong() != event->object.value
                              || row.value(2).toByteArray() != checkDigest(cpo))
                              return corrupt(database, "an action");
                          actions.push_back(*event);
                          return {};
                      })
        .map([&] { return std::move(actions); });
}

Result<void> writeActions(const QSqlDatabase& database, std::span<const EventCpo> events)
{
    return inTransaction(database, [&] {
        return forEach(events, [&](const EventCpo& event) { return writeAction(database, event); });
    });
}

Result<StoreContent> readContent(const QSqlDatabase& database)
{
    StoreContent content;
    return readFacts(database)
        .and_then([&](std::vector<FactRecord> facts) {
            content.facts = std::move(facts);
            return readAnchor(database);
        })
        .and_then([&](const std::optional<ClockAnchor>& anchor) {
            content.anchor = anchor;
            return readActions(database);
        })
        .map([&](const std::vector<EventCpo>& actions) {
            for (const EventCpo& event : actions)
                content.actions.insert_or_assign(event.object, event);
            return std::move(content);
        });
}

Result<void> writeContent(const QSqlDatabase& database, const StoreContent& content)
{
    return inTransaction(database, [&]() -> Result<void> {
        if (const auto stored = insertEach(database, content.facts); !stored)
            return stored;
        if (content.anchor)
            if (const auto stored = writeAnchor(database, *content.anchor); !stored)
                return stored;
        return forEach(content.actions,
                       [&](const auto& entry) { return writeAction(database, entry.second); });
    });
}

} // namespace carina
