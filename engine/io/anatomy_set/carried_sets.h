#pragma once

#include "engine/io/anatomy_set/imported_set.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

namespace carina
{

/// A set in the form in which it travels: a file as set_codec.h lays it out, without what the
/// import had to say about the files of the computer it ran on.
struct CarriedSet {
    std::string digest;      ///< BLAKE2b-256 of the file, 64 hexadecimal digits
    std::uint64_t bytes = 0; ///< its length
    std::string licence{};   ///< lines to show, at most CarriedSets::kLongestLicence bytes
};

/// A set that is on its way, as far as it is there: the file CARRIED/<digest>.part, which one
/// program at a time writes. It outlives that program, so that a transfer goes on where it broke
/// off.
class PartialSet
{
public:
    ~PartialSet();
    PartialSet(const PartialSet&) = delete;
    PartialSet& operator=(const PartialSet&) = delete;

    /// How much is there.
    [[nodiscard]] std::uint64_t bytes() const { return m_bytes; }
    /// @returns FileUnwritable, on a full disk too.
    [[nodiscard]] Result<void> append(std::span<const std::byte> bytes);
    /// Makes it a carried set once all is there.
    /// @returns FileMalformed when it is not what its digest says: nothing is kept of it then;
    ///          FileUnwritable.
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

/// Sets that travel between computers, each under the hash of its own bytes, so that nobody can
/// have another put in its place. They lie in the folder "carried" of the anatomy cache, apart from
/// what this computer imported itself (see docs/decisions/0008-sets-by-digest.md).
class CarriedSets
{
public:
    /// No longer ones are sent, or taken.
    static constexpr std::uint64_t kMostBytes = std::uint64_t{256} << 20U;
    static constexpr std::size_t kLongestLicence = 1024;

    /// How many bytes more the disk takes that a folder lies on.
    using RoomIn = std::uint64_t (*)(const std::filesystem::path& folder);
    [[nodiscard]] static std::uint64_t roomOnDisk(const std::filesystem::path& folder);

    /// @param cacheFolder usually AnatomyCache::defaultFolder()
    explicit CarriedSets(std::filesystem::path cacheFolder, RoomIn roomIn = &roomOnDisk);

    /// Puts the set that the cache holds under this content hash into the form that travels.
    /// @returns what AnatomyCache::load does; OutOfRange for one that is too long; FileUnwritable.
    [[nodiscard]] Result<CarriedSet> prepare(const std::string& contentHash) const;

    [[nodiscard]] bool has(const CarriedSet& set) const;
    /// Where it lies, or will lie.
    [[nodiscard]] std::filesystem::path file(const std::string& digest) const;

    /// What is there of a set that is not there whole; null while another program writes it.
    /// @returns FileUnwritable, also where the disk has no room for the rest.
    [[nodiscard]] Result<std::unique_ptr<PartialSet>> resume(const CarriedSet& set) const;

    /// The set, held against its digest, the content hash that it should have, and checkSet.
    /// @returns FileNotFound; FileMalformed for anything else than that set.
    [[nodiscard]] Result<ImportedSet> load(const std::string& digest,
                                           const std::string& contentHash) const;

private:
    std::filesystem::path m_cacheFolder;
    RoomIn m_roomIn;
};

} // namespace carina
