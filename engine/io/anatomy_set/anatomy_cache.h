#pragma once

#include "engine/io/anatomy_set/imported_set.h"

#include <filesystem>
#include <optional>
#include <string>

namespace carina
{

/// Imported sets on disk, so that a start does not parse their files again.
///
///     <content hash>.anatomy    the set (set_codec.h)
///     <content hash>.json       what it holds (set_description.h), for people
///     <listing hash>.listing    the content hash of a folder whose files look so
///
/// Each file is written beside its place and renamed into it, so that a half-written one is never
/// met; a set that is damaged all the same is refused by its checksum and imported anew.
class AnatomyCache
{
public:
    explicit AnatomyCache(std::filesystem::path folder);

    /// The folder that the user's desktop gives to caches, with carina/anatomy below it.
    [[nodiscard]] static std::filesystem::path defaultFolder();

    /// The content hash last found for files that look so (see listingHashOf).
    [[nodiscard]] std::optional<std::string> contentHash(const std::string& listingHash) const;

    /// @returns FileNotFound when it is not there; FileMalformed when it is not as it was written.
    [[nodiscard]] Result<ImportedSet> load(const std::string& contentHash) const;

    /// @returns FileUnwritable
    [[nodiscard]] Result<void> store(const ImportedSet& set) const;
    /// The same, and remembers the listing that it was made from.
    [[nodiscard]] Result<void> store(const ImportedSet& set, const std::string& listingHash) const;

    /// Remembers that files that look so hold this content.
    /// @returns FileUnwritable
    [[nodiscard]] Result<void> remember(const std::string& listingHash,
                                        const std::string& contentHash) const;

    [[nodiscard]] std::filesystem::path setFile(const std::string& contentHash) const;

private:
    std::filesystem::path m_folder;
};

} // namespace carina
