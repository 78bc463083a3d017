#include "engine/io/fact_store/sql_fact_store.h"

#include "engine/io/fact_store/sql_database.h"
#include "engine/sync/wire/cpo_codec.h"

#include <QFile>
#include <QSqlError>

#include <atomic>
#include <limits>
#include <optional>
#include <span>
#include <thread>

namespace carina
{

namespace
{

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
        if (const Result<void> ready = prepareStore(database); !ready) {
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
        Result<QSqlQuery> rows = executeSql(
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
            executeSql(*database,
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
            executeSql(*database, QStringLiteral("SELECT boot_id, offset_ns FROM clock_anchor"));
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
        const Result<QSqlQuery> stored = executeSql(
            *database, QStringLiteral("INSERT OR REPLACE INTO clock_anchor VALUES (0, ?, ?)"),
            {QString::fromStdString(anchor.bootId), qint64(anchor.offset.count())});
        if (!stored)
            return tl::unexpected(stored.error());
        return {};
    }

    Result<std::vector<EventCpo>> actions() override
    {
        const Result<QSqlDatabase> database = connection();
        if (!database)
            return tl::unexpected(database.error());
        Result<QSqlQuery> rows = executeSql(
            *database,
            QStringLiteral("SELECT substr(cpo, 1, %1) FROM action").arg(kEventCpoBytes + 1));
        if (!rows)
            return tl::unexpected(rows.error());
        std::vector<EventCpo> actions;
        while (rows->next()) {
            const QByteArray cpo = rows->value(0).toByteArray();
            ByteReader in{std::as_bytes(std::span{cpo.constData(), std::size_t(cpo.size())})};
            actions.push_back(readEventCpo(in));
            if (!in.ok() || in.remaining() != 0)
                return fail(Errc::StoreCorrupt, m_path.toStdString() + ": an action");
        }
        if (rows->lastError().isValid())
            return tl::unexpected(storeError(m_path, rows->lastError()));
        return actions;
    }

    Result<void> keepAction(const EventCpo& event) override
    {
        const Result<QSqlDatabase> database = connection();
        if (!database)
            return tl::unexpected(database.error());
        std::vector<std::byte> bytes;
        ByteWriter out{bytes};
        writeEventCpo(out, event);
        const QByteArray cpo{reinterpret_cast<const char*>(bytes.data()), qsizetype(bytes.size())};
        const Result<QSqlQuery> stored =
            executeSql(*database, QStringLiteral("INSERT OR REPLACE INTO action VALUES (?, ?)"),
                       {event.object.value, cpo});
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
