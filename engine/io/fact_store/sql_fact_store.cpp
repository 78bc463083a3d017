#include "engine/io/fact_store/sql_fact_store.h"

#include "engine/io/fact_store/sql_database.h"
#include "engine/io/fact_store/store_file.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <functional>
#include <thread>
#include <utility>

namespace carina
{
namespace
{

/// Keeps one connection, of the thread that used it last: Qt ties a connection to its thread. Keeps
/// what is stored in memory too, for a new file where the first is lost.
class SqlFactStore final : public FactStore
{
public:
    explicit SqlFactStore(QString path) : m_path{std::move(path)} {}

    Result<void> open()
    {
        if (!QFile::exists(m_path))
            if (const Result<void> created = createStoreFile(m_path, {}); !created)
                return created;
        return connection().map([](const QSqlDatabase&) {});
    }

    Result<std::vector<FactRecord>> load() override
    {
        return remember().map([this] { return m_content->facts; });
    }

    Result<void> append(std::span<const FactRecord> facts) override
    {
        return remember().and_then([&] { return areNext(facts); }).and_then([&] {
            return store([&](const QSqlDatabase& database) { return insertFacts(database, facts); },
                         [&](StoreContent& content) {
                             content.facts.insert(content.facts.end(), facts.begin(), facts.end());
                         });
        });
    }

    Result<std::optional<ClockAnchor>> clockAnchor() override
    {
        return remember().map([this] { return m_content->anchor; });
    }

    Result<void> setClockAnchor(const ClockAnchor& anchor) override
    {
        return remember().and_then([&] {
            return store(
                [&](const QSqlDatabase& database) { return writeAnchor(database, anchor); },
                [&](StoreContent& content) { content.anchor = anchor; });
        });
    }

    Result<std::vector<EventCpo>> actions() override
    {
        return remember().map([this] {
            std::vector<EventCpo> actions;
            for (const auto& [object, event] : m_content->actions)
                actions.push_back(event);
            return actions;
        });
    }

    Result<void> keepActions(std::span<const EventCpo> events) override
    {
        return remember().and_then([&] {
            return store(
                [&](const QSqlDatabase& database) { return writeActions(database, events); },
                [&](StoreContent& content) {
                    for (const EventCpo& event : events)
                        content.actions.insert_or_assign(event.object, event);
                });
        });
    }

    Result<std::optional<std::filesystem::path>> keepWhole() override
    {
        return remember().and_then([this] { return wholeFile(); }).map([this](const QSqlDatabase&) {
            return std::exchange(m_moved, std::nullopt);
        });
    }

private:
    using Write = std::function<Result<void>(const QSqlDatabase&)>;

    /// The connection of this thread.
    Result<QSqlDatabase> connection()
    {
        if (m_connection && m_thread == std::this_thread::get_id())
            return m_connection->database();
        m_connection.reset(); // which gives its lock back
        m_connection = std::make_unique<SqlConnection>(m_path);
        QSqlDatabase database = m_connection->database();
        if (const Result<void> ready = openStoreFile(database); !ready) {
            database = {};
            m_connection.reset();
            return tl::unexpected(ready.error());
        }
        m_thread = std::this_thread::get_id();
        m_stamp = StoreStamp::of(m_path);
        return database;
    }

    /// @pre remember()
    [[nodiscard]] Result<void> areNext(std::span<const FactRecord> facts) const
    {
        std::uint64_t last = m_content->facts.size();
        for (const FactRecord& fact : facts)
            if (fact.number.value != ++last)
                return fail(Errc::StoreFailed, m_path.toStdString() + ": fact "
                                                   + std::to_string(fact.number.value)
                                                   + " is not the next");
        return {};
    }

    /// Reads the file into memory, the first time.
    Result<void> remember()
    {
        if (m_content)
            return {};
        return connection().and_then(readContent).map([this](StoreContent content) {
            m_content = std::move(content);
            m_stamp = StoreStamp::of(m_path); // reading creates the -wal
        });
    }

    /// The connection to a file in which everything is: where somebody deleted, replaced or changed
    /// the file since the last write, that of a new one. @pre remember()
    Result<QSqlDatabase> wholeFile()
    {
        if (!StoreStamp::of(m_path).isUnchanged(m_stamp))
            m_isLost = true;
        if (m_isLost)
            if (const Result<void> saved = saveToNewFile(*m_content); !saved)
                return tl::unexpected(saved.error());
        return connection();
    }

    /// Stores something, on the disk and then in memory. The file may be lost between the check
    /// before and the write, so it is checked again after it.
    Result<void> store(const Write& write, const std::function<void(StoreContent&)>& add)
    {
        const Result<void> written = wholeFile().and_then(write);
        const StoreStamp stamp = StoreStamp::of(m_path);
        if (stamp.isSameFiles(m_stamp)) {
            m_stamp = stamp;
            if (written)
                add(*m_content);
            return written;
        }
        m_isLost = true;
        StoreContent content = *m_content;
        add(content);
        return saveToNewFile(std::move(content));
    }

    /// The new file is opened by who uses it next.
    Result<void> saveToNewFile(StoreContent content)
    {
        m_connection.reset();
        QDir{}.mkpath(QFileInfo{m_path}.path());
        const QString next = freeNameBeside(m_path);
        if (const Result<void> created = createStoreFile(next, content); !created)
            return created;
        m_content = std::move(content);
        m_path = next;
        m_stamp = StoreStamp::of(next);
        m_moved = QFile::encodeName(next).toStdString();
        m_isLost = false;
        return {};
    }

    QString m_path;
    std::unique_ptr<SqlConnection> m_connection;
    std::thread::id m_thread;
    std::optional<StoreContent> m_content;
    StoreStamp m_stamp; // of the last write
    bool m_isLost = false;
    std::optional<std::filesystem::path> m_moved; // not told yet
};

} // namespace

Result<std::unique_ptr<FactStore>> openFactStore(const std::filesystem::path& path)
{
    auto store = std::make_unique<SqlFactStore>(QFile::decodeName(path.c_str()));
    if (const Result<void> opened = store->open(); !opened)
        return tl::unexpected(opened.error());
    return store;
}

} // namespace carina
