#pragma once

#include "engine/io/anatomy_set/imported_set.h"

#include <filesystem>
#include <optional>
#include <string>

namespace carina
{

/// Imported sets on disk, so that a later start does not parse their files again.
///
///     <content hash>.anatomy    the set (set_codec.h)
///     <content hash>.json       its contents (set_description.h), for people
///     <listing hash>.listing    the content hash of a folder with this listing
///
/// Files are written under a temporary name and renamed, so that no incomplete file is read. A
/// damaged set is refused by its checksum and imported again.
class AnatomyCache
{
public:
    explicit AnatomyCache(std::filesystem::path folder);

    /// The folder carina/anatomy in the cache location of the user's desktop.
    [[nodiscard]] static std::filesystem::path defaultFolder();

    /// The content hash last stored for this listing (see listingHashOf).
    [[nodiscard]] std::optional<std::string> contentHash(const std::string& listingHash) const;

    /// @returns FileNotFound where it is not in the cache; FileMalformed where it is damaged.
    [[nodiscard]] Result<ImportedSet> load(const std::string& contentHash) const;

    /// Writes the set. @returns FileUnwritable
    [[nodiscard]] Result<void> store(const ImportedSet& set) const;
    /// Writes the set, and its content hash for the listing that it was imported from.
    [[nodiscard]] Result<void> store(const ImportedSet& set, const std::string& listingHash) const;

    /// Stores the content hash for a listing.
    /// @returns FileUnwritable
    [[nodiscard]] Result<void> remember(const std::string& listingHash,
                                        const std::string& contentHash) const;

    [[nodiscard]] std::filesystem::path setFile(const std::string& contentHash) const;

private:
    std::filesystem::path m_folder;
};

} // namespace carina
