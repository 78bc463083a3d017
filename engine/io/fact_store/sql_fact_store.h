#pragma once

#include "engine/core/result.h"
#include "engine/session/facts/fact_store.h"

#include <filesystem>
#include <memory>

namespace carina
{

/// Opens the log of one session in an SQLite file, or creates it where there is no file.
///
/// Facts that are appended together are one transaction, synced to disk before append returns.
/// While the store is open no other program can use the file. It may be used from any thread, one
/// at a time. The file is for its owner's eyes only (mode 0600): it holds the participants' names.
///
/// Every row has a digest, so that a bit that flipped on the disk is noticed when the log is read.
///
/// @pre a QCoreApplication exists.
/// @returns StoreCorrupt for a file that is empty, truncated or not a database, UnknownFormat for a
///          database of another program or of a newer Carina, StoreTooOld for one of an earlier
///          Carina whose facts cannot be read, StoreFailed where it cannot be opened or another
///          program has it open. On failure the file is unchanged.
[[nodiscard]] Result<std::unique_ptr<FactStore>> openFactStore(const std::filesystem::path& path);

} // namespace carina
