#include "engine/io/fact_store/store_file.h"

#include "engine/io/fact_store/sql_database.h"
#include "engine/io/files/whole_file.h"

#include <QFile>
#include <QFileInfo>
#include <QSqlError>
#include <QTemporaryFile>

#include <algorithm>
#include <array>
#include <string>
#include <sys/stat.h>

namespace carina
{
namespace
{

constexpr int kStoreApplicationId = 0x4352'4e41; // "CRNA", read by file(1) and by us
constexpr int kStoreVersion = 3;
// Of a time when some facts were encoded otherwise, the newest.
constexpr int kUnreadableVersion = 2;

const QString kChanges = QStringLiteral("-wal");

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

Result<void> setVersion(const QSqlDatabase& database)
{
    return executeAll(database, {QStringLiteral("PRAGMA user_version = %1").arg(kStoreVersion)});
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
    if (version->toInt() >= 1 && version->toInt() <= kUnreadableVersion)
        return fail(Errc::StoreTooOld, path);
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

void closeToOthers(const QString& path)
{
    for (const QString& file : {path, path + kChanges})
        if (QFile::exists(file)) // fails where it is another user's
            QFile::setPermissions(file, QFile::ReadOwner | QFile::WriteOwner);
}

/// Into an empty file that nobody else knows yet.
Result<void> fillFile(const QString& file, const StoreContent& content)
{
    const SqlConnection connection{file};
    QSqlDatabase database = connection.database();
    if (!database.open())
        return tl::unexpected(storeError(file, database.lastError()));
    return executeAll(database,
                      {QStringLiteral("PRAGMA journal_mode = MEMORY"),
                       QStringLiteral("PRAGMA synchronous = FULL"),
                       QStringLiteral("PRAGMA application_id = %1").arg(kStoreApplicationId)})
        .and_then([&] {
            return inTransaction(database, [&] {
                return createRows(database).and_then([&] { return setVersion(database); });
            });
        })
        .and_then([&] { return writeContent(database, content); });
}

StoreStamp::File stampOf(const QString& path)
{
    struct stat found {
    };
    if (stat(QFile::encodeName(path).constData(), &found) != 0)
        return {};
    return {found.st_dev, found.st_ino, found.st_size, found.st_mtim};
}

} // namespace

Result<void> createStoreFile(const QString& path, const StoreContent& content)
{
    QTemporaryFile file{path + QStringLiteral(".XXXXXX")}; // of mode 0600
    if (!file.open())
        return fail(Errc::StoreFailed,
                    path.toStdString() + ": " + file.errorString().toStdString());
    file.close();
    const Result<void> filled = fillFile(file.fileName(), content);
    if (!filled)
        return fail(filled.error().code, path.toStdString() + ": " + filled.error().detail);
    if (const auto placed = placeFile(file.fileName().toStdString(), path.toStdString()); !placed)
        return fail(Errc::StoreFailed, placed.error().detail);
    file.setAutoRemove(false);
    return {};
}

Result<void> openStoreFile(QSqlDatabase& database)
{
    const QString path = database.databaseName();
    if (QFileInfo{path}.size() == 0)
        return fail(Errc::StoreCorrupt, path.toStdString() + ": it is empty");
    const bool hasChangesBeside = QFile::exists(path + kChanges);
    if (!database.open())
        return tl::unexpected(storeError(path, database.lastError()));
    return executeAll(database, {QStringLiteral("PRAGMA locking_mode = EXCLUSIVE")})
        .and_then([&] { return checkSchema(database, hasChangesBeside); })
        .and_then([&] {
            closeToOthers(path);
            return executeAll(database, {QStringLiteral("PRAGMA journal_mode = WAL"),
                                         QStringLiteral("PRAGMA synchronous = FULL")});
        });
}

StoreStamp StoreStamp::of(const QString& path) { return {stampOf(path), stampOf(path + kChanges)}; }

QString freeNameBeside(const QString& path)
{
    const QFileInfo file{path};
    const QString ending = file.suffix().isEmpty() ? QString{} : QLatin1Char{'.'} + file.suffix();
    const QString stem = path.chopped(ending.size());
    for (int i = 2;; ++i) {
        const QString name = stem + QStringLiteral("_%1").arg(i) + ending;
        if (!QFile::exists(name) && !QFile::exists(name + kChanges))
            return name;
    }
}

} // namespace carina
