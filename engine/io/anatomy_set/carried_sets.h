#pragma once

#include "engine/io/anatomy_set/imported_set.h"
#include "engine/io/files/file_limit.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

namespace carina
{

/// A set in the form in which it is transferred: a file as in set_codec.h, without the faults and
/// leftOut of the import.
struct CarriedSet {
    std::string digest;      ///< BLAKE2b-256 of the file, 64 hexadecimal digits
    std::uint64_t bytes = 0; ///< its length
    std::string licence{};   ///< lines to show, at most CarriedSets::kLongestLicence bytes
};

/// The part of a set received so far: the file CARRIED/<digest>.part, which one program at a time
/// writes. It remains after that program ends, so that an interrupted transfer can be resumed.
class PartialSet
{
public:
    ~PartialSet();
    PartialSet(const PartialSet&) = delete;
    PartialSet& operator=(const PartialSet&) = delete;

    /// Bytes received so far.
    [[nodiscard]] std::uint64_t bytes() const { return m_bytes; }
    /// @returns FileUnwritable, also where the disk is full.
    [[nodiscard]] Result<void> append(std::span<const std::byte> bytes);
    /// Turns the complete file into a carried set.
    /// @returns FileMalformed where it does not match its digest, and deletes it; FileUnwritable.
    [[nodiscard]] Result<void> finish();

private:
    friend class CarriedSets;
    PartialSet(int file, std::uint64_t bytes, std::filesystem::path part,
               std::filesystem::path whole, std::string digest);

    int m_file;
    std::uint64_t m_bytes;
    std::filesystem::path m_part;
    std::filesystem::path m_whole;
    std::string m_digest;
};

/// Sets transferred between computers, each stored under the hash of its own bytes, so that none
/// can be replaced by another. They are in the folder "carried" of the anatomy cache, apart from
/// what this computer imported itself (see docs/decisions/0008-sets-by-digest.md).
class CarriedSets
{
public:
    /// Largest set that is sent or accepted.
    static constexpr std::uint64_t kMostBytes = kCarriedSetLimit.mostBytes;
    static constexpr std::size_t kLongestLicence = 1024;

    /// Returns the free bytes on the disk of a folder.
    using RoomIn = std::uint64_t (*)(const std::filesystem::path& folder);
    [[nodiscard]] static std::uint64_t roomOnDisk(const std::filesystem::path& folder);

    /// @param cacheFolder usually AnatomyCache::defaultFolder()
    explicit CarriedSets(std::filesystem::path cacheFolder, RoomIn roomIn = &roomOnDisk);

    /// Writes the cached set with this content hash in the form in which it is transferred.
    /// @returns the errors of AnatomyCache::load; OutOfRange where it is larger than kMostBytes;
    ///          FileUnwritable.
    [[nodiscard]] Result<CarriedSet> prepare(const std::string& contentHash) const;

    /// Whether the set is complete on this computer.
    [[nodiscard]] bool has(const CarriedSet& set) const;
    /// The file of a set, whether it exists or not.
    [[nodiscard]] std::filesystem::path file(const std::string& digest) const;

    /// The part of a set received so far; null while another program writes it.
    /// @returns FileUnwritable, also where the disk has too little room for the rest.
    [[nodiscard]] Result<std::unique_ptr<PartialSet>> resume(const CarriedSet& set) const;

    /// The set, after checking it against its digest, its content hash and checkSet.
    /// @returns FileNotFound; FileMalformed where a check fails.
    [[nodiscard]] Result<ImportedSet> load(const std::string& digest,
                                           const std::string& contentHash) const;

private:
    std::filesystem::path m_cacheFolder;
    RoomIn m_roomIn;
};

} // namespace carina
