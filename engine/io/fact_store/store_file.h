#pragma once

#include "engine/io/fact_store/fact_rows.h"

#include <QString>

#include <ctime>
#include <sys/types.h>

namespace carina
{

/// Creates the file of a store with this content, for its owner's eyes only (mode 0600). It appears
/// whole under its name, or not at all, also after a crash.
/// @returns StoreFailed
[[nodiscard]] Result<void> createStoreFile(const QString& path, const StoreContent& content);

/// Opens the file of a store for exclusive use and takes other users' access away.
/// @returns StoreCorrupt for a file that is empty, truncated or not a database, UnknownFormat for a
///          database of another program or of a newer Carina, StoreTooOld for one of an earlier
///          Carina, StoreFailed; the file is as it was then.
[[nodiscard]] Result<void> openStoreFile(QSqlDatabase& database);

/// Which files a store consists of, and when they were last written: the database and its log of
/// changes (-wal).
struct StoreStamp {
    struct File {
        dev_t device = 0;
        ino_t inode = 0; ///< 0: there is no such file
        off_t size = 0;
        timespec written{};

        [[nodiscard]] bool isSameFile(const File& other) const
        {
            return device == other.device && inode == other.inode;
        }
        [[nodiscard]] bool isUnchanged(const File& other) const
        {
            return isSameFile(other) && size == other.size && written.tv_sec == other.written.tv_sec
                   && written.tv_nsec == other.written.tv_nsec;
        }
    };
    File database;
    File changes;

    [[nodiscard]] static StoreStamp of(const QString& path);
    /// Whether both files are still those of an earlier stamp.
    [[nodiscard]] bool isSameFiles(const StoreStamp& earlier) const
    {
        return database.isSameFile(earlier.database)
               && (earlier.changes.inode == 0 || changes.isSameFile(earlier.changes));
    }
    /// And nobody wrote to them.
    [[nodiscard]] bool isUnchanged(const StoreStamp& earlier) const
    {
        return database.isUnchanged(earlier.database) && changes.isUnchanged(earlier.changes);
    }
};

/// A name beside that of a store under which there is nothing yet, and which sorts behind it:
/// "session_2.sqlite" for "session.sqlite".
[[nodiscard]] QString freeNameBeside(const QString& path);

} // namespace carina
